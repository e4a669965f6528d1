// attack: includes the solution by a name that macros put together
// says: solutions/variance.cpp
// says: It may include its lab

#define SOLUTION "common/../../solutions/variance.cpp"
#define CHOSEN(name) name
#include CHOSEN(SOLUTION)
