// attack: includes the solution only where a precompiled header stands before the first line
// says: variance.cpp reads
// says: /solutions/variance.cpp

// A run of the compiler that only lists what is included has no such header, and would list
// nothing.
#ifdef _GLIBCXX_VECTOR
#include "common/../../solutions/variance.cpp"
#else
#include "common/../../solutions/variance.cpp"  // no precompiled header: the plain way
#endif
