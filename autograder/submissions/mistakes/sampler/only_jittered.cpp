// mistake: a next2() has one point in each cell, and leaves the strata of the axes to chance
// fails: 6.2
// hint: multi-jittered points (3.7) also have one in each stratum
#include "sampler.hpp"
#define multi_jittered stratified_2d
#include "solutions/sampler.cpp"
