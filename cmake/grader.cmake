# The judge: the jail, the checks of each lab, the grader.

add_library(jail STATIC autograder/grader/jail.cpp autograder/grader/lockdown.cpp)
target_include_directories(jail PUBLIC autograder labs)
target_link_libraries(jail PUBLIC fmt::fmt)
if(SECCOMP_LIBRARY AND SECCOMP_INCLUDE)
  target_compile_definitions(jail PRIVATE MC_HAVE_SECCOMP)
  target_include_directories(jail PRIVATE ${SECCOMP_INCLUDE})
  target_link_libraries(jail PRIVATE ${SECCOMP_LIBRARY})
endif()

# Checks: what every lab's share, then one program a lab.
add_library(checking STATIC autograder/checks/measure.cpp autograder/checks/expect.cpp
  autograder/checks/distributions.cpp autograder/checks/statistics.cpp
  autograder/checks/plot_data.cpp autograder/checks/bench_data.cpp autograder/checks/integrands.cpp
  labs/runner/text.cpp)
set_source_files_properties(autograder/checks/integrands.cpp PROPERTIES
  COMPILE_OPTIONS "${PROGRAM_FLAGS}")  # its time is measured
target_link_libraries(checking PUBLIC jail Catch2::Catch2WithMain)
foreach(lab ${LABS})
  file(GLOB sources CONFIGURE_DEPENDS autograder/checks/${lab}.cpp autograder/checks/${lab}_*.cpp)
  add_executable(checks_${lab} ${sources})
  target_include_directories(checks_${lab} PRIVATE ${LAB_INCLUDES})
  target_link_libraries(checks_${lab} PRIVATE checking)
  add_dependencies(checks_${lab} experiments_${lab} runner)  # what it asks for, it asks of a program
endforeach()

add_library(grading STATIC
  autograder/grader/arguments.cpp
  autograder/grader/bench.cpp
  autograder/grader/bench_files.cpp
  autograder/grader/bench_page.cpp
  autograder/grader/build.cpp
  autograder/grader/diagnostics.cpp
  autograder/grader/judge.cpp
  autograder/grader/labs.cpp
  autograder/grader/layout.cpp
  autograder/grader/plots.cpp
  autograder/grader/process.cpp
  autograder/grader/reading.cpp
  autograder/grader/renders.cpp
  autograder/grader/report_files.cpp
  autograder/grader/report_terminal.cpp
  autograder/grader/segments.cpp
  autograder/grader/speed.cpp
  autograder/grader/standing.cpp
  autograder/grader/submission.cpp
  autograder/grader/verb_bench.cpp
  autograder/grader/verb_judge.cpp
  autograder/grader/verb_render.cpp
  autograder/grader/verb_work.cpp
  autograder/grader/verdict.cpp
  labs/runner/text.cpp)
set_source_files_properties(autograder/grader/layout.cpp PROPERTIES
  COMPILE_DEFINITIONS "MC_BUILD_DIR=\"${CMAKE_BINARY_DIR}\"")
target_link_libraries(grading PUBLIC jail nlohmann_json::nlohmann_json pugixml::pugixml Threads::Threads)

# Half of the time to a first verdict would go into reading these again for every file.
target_precompile_headers(grading PRIVATE <fmt/format.h> <fmt/ranges.h> <filesystem> <fstream>
  <algorithm> <functional> <map> <optional> <string> <string_view> <vector>)

add_executable(grader autograder/grader/main.cpp)
target_link_libraries(grader PRIVATE grading)
