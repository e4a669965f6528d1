// attack: looks for the solution by __has_include, in case it is somewhere else
// says: solutions/variance.cpp
// says: It may include its lab

#if __has_include("../solutions/variance.cpp")
#include "../solutions/variance.cpp"
#elif __has_include("common/../../solutions/variance.cpp")
#include "common/../../solutions/variance.cpp"
#else
#include "/autograder/source/solutions/variance.cpp"
#endif
