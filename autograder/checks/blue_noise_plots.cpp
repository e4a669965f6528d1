// The data of lab 4's plots.
#include "4-blue-noise/experiments.hpp"
#include "checks/plot_data.hpp"
