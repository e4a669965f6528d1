// attack: includes the solution, by a path from a directory of headers
// says: variance.cpp reads
// says: It may include its lab

#include "common/../../solutions/variance.cpp"
