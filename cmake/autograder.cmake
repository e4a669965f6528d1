# The sandbox, the protocol, the checks of each lab, the judge, its commands, the bench. Includes
# point downward only: bench, commands -> classes -> judge -> protocol, sandbox <- checks.

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
# benchmark and demo. A lab without measurements has no measure_LAB. If it has a table of methods, both
# have what every lab measures of these.
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
  set(table autograder/measurements/${lab})
  set(speed)
  set(cases)
  file(GLOB methods CONFIGURE_DEPENDS ${table}/methods.hpp)
  if(methods)
    set(speed autograder/measurements/every_lab/speed.cpp)
    set(cases autograder/measurements/every_lab/cases.cpp)
  endif()
  file(GLOB sources CONFIGURE_DEPENDS autograder/checks/${lab}/*.cpp)
  add_executable(checks_${lab} ${sources} ${speed})
  target_link_libraries(checks_${lab} PRIVATE checking)
  file(GLOB sources CONFIGURE_DEPENDS ${table}/*.cpp)
  if(sources)
    list(APPEND programs measure_${lab})
    add_executable(measure_${lab} ${sources} ${cases})
    target_link_libraries(measure_${lab} PRIVATE measuring)
  endif()
  if(NOT TARGET measure_${lab})
    add_custom_target(measure_${lab})
  endif()
  foreach(target ${programs})
    own_target(${target})
    target_compile_options(${target} PRIVATE ${HOT})
    target_include_directories(${target} PRIVATE ${LAB_INCLUDES} ${table})
    add_dependencies(judge_all ${target})
    add_dependencies(${target} experiments_${lab} runner)  # it sends its requests to a program
  endforeach()
endforeach()

# One program has all commands. It links object libraries, because commands register themselves:
# nothing refers to them by name.
file(GLOB sources CONFIGURE_DEPENDS autograder/judge/*/*.cpp autograder/classes/*.cpp
  autograder/commands/*.cpp autograder/bench/*.cpp)
list(FILTER sources EXCLUDE REGEX "/submission/archive[.]cpp$|/commands/main[.]cpp$")
add_library(judge OBJECT ${sources})
own_target(judge)
# Users wait for this: common headers are parsed once, and the templates of the JSON library are
# compiled once, its users together.
if(MC_UNITY)
  target_precompile_headers(judge PRIVATE <algorithm> <filesystem> <functional> <map> <mutex>
    <optional> <set> <sstream> <string> <thread> <vector> <fmt/format.h> <fmt/ranges.h>)
  set_target_properties(judge PROPERTIES UNITY_BUILD_MODE GROUP)
  set(count 0)
  foreach(source ${sources})
    file(STRINGS ${source} uses_json REGEX "<nlohmann/" LIMIT_COUNT 1)
    math(EXPR part "${count} / 14")
    if(uses_json)
      set(part json)
    else()
      math(EXPR count "${count} + 1")
    endif()
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${part})
  endforeach()
endif()
add_library(archives STATIC autograder/judge/submission/archive.cpp)  # a handout has none
own_target(archives)
target_link_libraries(archives PUBLIC sandbox)
if(ARCHIVE_LIBRARY AND ARCHIVE_INCLUDE)
  target_compile_definitions(archives PRIVATE MC_HAVE_ARCHIVE)
  target_include_directories(archives PRIVATE ${ARCHIVE_INCLUDE})
  target_link_libraries(archives PUBLIC ${ARCHIVE_LIBRARY})
endif()
target_link_libraries(judge PUBLIC archives sandbox protocol nlohmann_json::nlohmann_json
  Threads::Threads)
add_executable(lab autograder/commands/main.cpp)
own_target(lab)
target_link_libraries(lab PRIVATE judge)
add_dependencies(judge_all lab)
# What ./lab builds at first: the program and, on the other cores, the checks of the first lab.
list(GET LABS 0 first)
add_custom_target(start DEPENDS lab checks_${first})
