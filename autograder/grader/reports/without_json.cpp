// For the program that writes no JSON: its library takes as long to compile as all the rest of a
// check.
#include "grader/reports/report.hpp"

namespace mc::grader {

const JsonReporter report_json = nullptr;

}  // namespace mc::grader
