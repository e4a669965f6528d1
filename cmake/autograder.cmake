# The judge: the sandbox, the protocol, the checks of each lab, the grader, the bench. Includes
# point downward only: bench -> grader -> protocol, sandbox <- checks.

file(GLOB sources CONFIGURE_DEPENDS autograder/sandbox/*.cpp)
add_library(sandbox STATIC ${sources})
own_target(sandbox)
target_link_libraries(sandbox PUBLIC fmt::fmt)
if(SECCOMP_LIBRARY AND SECCOMP_INCLUDE)
  target_compile_definitions(sandbox PRIVATE MC_HAVE_SECCOMP)
  target_include_directories(sandbox PRIVATE ${SECCOMP_INCLUDE})
  target_link_libraries(sandbox PRIVATE ${SECCOMP_LIBRARY})
endif()

file(GLOB sources CONFIGURE_DEPENDS autograder/protocol/*.cpp)
add_library(protocol STATIC ${sources} labs/runner/text.cpp)
own_target(protocol)

# Two programs per lab: checks_LAB judges and times the speed tasks, measure_LAB measures for plots,
# benchmark and demo. A lab without measurements has no measure_LAB.
file(GLOB sources CONFIGURE_DEPENDS autograder/checks/support/*.cpp)
add_library(checking STATIC ${sources} autograder/measurements/support/speed_data.cpp)
own_target(checking)
target_compile_options(checking PRIVATE ${HOTTEST})
target_link_libraries(checking PUBLIC sandbox protocol Catch2::Catch2WithMain)
# Catch2 2.13 declares listeners only then (records.cpp).
target_compile_definitions(checking PRIVATE CATCH_CONFIG_EXTERNAL_INTERFACES)
file(GLOB sources CONFIGURE_DEPENDS autograder/measurements/support/*.cpp)
list(FILTER sources EXCLUDE REGEX "/speed_data[.]cpp$")
add_library(measuring STATIC ${sources})  # integrands are timed, so use the flags of submissions
own_target(measuring)
target_compile_options(measuring PRIVATE ${PROGRAM_FLAGS})
target_link_libraries(measuring PUBLIC checking PRIVATE nlohmann_json::nlohmann_json)
add_custom_target(judge_all)  # targets that ./lab grade needs
foreach(lab ${LABS})
  set(programs checks_${lab})
  file(GLOB sources CONFIGURE_DEPENDS autograder/checks/${lab}/*.cpp
    autograder/measurements/${lab}/speed.cpp)
  add_executable(checks_${lab} ${sources})
  target_link_libraries(checks_${lab} PRIVATE checking)
  file(GLOB sources CONFIGURE_DEPENDS autograder/measurements/${lab}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/speed[.]cpp$")
  if(sources)
    list(APPEND programs measure_${lab})
    add_executable(measure_${lab} ${sources})
    target_link_libraries(measure_${lab} PRIVATE measuring)
  endif()
  foreach(target ${programs})
    own_target(${target})
    target_compile_options(${target} PRIVATE ${HOT})
    target_include_directories(${target} PRIVATE ${LAB_INCLUDES})
    add_dependencies(judge_all ${target})
    add_dependencies(${target} experiments_${lab} runner)  # it sends its requests to a program
  endforeach()
endforeach()

# Two programs: `grader` has the commands that students need at once, `course` has all. They link object
# libraries, because commands register themselves: nothing refers to them by name.
file(GLOB all CONFIGURE_DEPENDS autograder/grader/*/*.cpp)
set(sources ${all})
list(FILTER sources EXCLUDE REGEX "/(gradebook|pictures)/|/submission/archive[.]cpp$")
list(FILTER sources EXCLUDE REGEX "/reports/(csv|html|json|verdict_json)[.]cpp$")
list(FILTER sources EXCLUDE REGEX
  "/commands/(bench|completion|demo|export|feedback|grade|gradescope|handout|merge|new_lab|plot|release|render|report|stats|tree|upgrade)[.]cpp$")
add_library(grading OBJECT ${sources})
own_target(grading)
add_library(archives STATIC autograder/grader/submission/archive.cpp)  # a handout has none
own_target(archives)
target_link_libraries(archives PUBLIC sandbox)
if(ARCHIVE_LIBRARY AND ARCHIVE_INCLUDE)
  target_compile_definitions(archives PRIVATE MC_HAVE_ARCHIVE)
  target_include_directories(archives PRIVATE ${ARCHIVE_INCLUDE})
  target_link_libraries(archives PUBLIC ${ARCHIVE_LIBRARY})
endif()
target_link_libraries(grading PUBLIC archives sandbox protocol Threads::Threads)

list(REMOVE_ITEM all ${sources} ${CMAKE_SOURCE_DIR}/autograder/grader/submission/archive.cpp)
if(EXISTS ${CMAKE_SOURCE_DIR}/autograder/bench)
  file(GLOB sources CONFIGURE_DEPENDS autograder/bench/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/measurement[.]cpp$")
  list(APPEND all ${sources})
endif()
add_library(coursework OBJECT ${all})
own_target(coursework)
in_parts(coursework 8)
target_link_libraries(coursework PUBLIC sandbox protocol nlohmann_json::nlohmann_json)

add_executable(grader autograder/grader/main.cpp)
add_executable(course autograder/grader/main.cpp)
target_link_libraries(course PRIVATE coursework)
foreach(program grader course)
  own_target(${program})
  target_link_libraries(${program} PRIVATE grading)
endforeach()
add_dependencies(judge_all course)
