// attack: includes the solution, by a path from where the compiler runs
// says: ../../../solutions/variance.cpp

#include "../../../solutions/variance.cpp"
