# The judge: the sandbox, the protocol, the checks of each lab, the grader, the bench. Includes
# point downwards only: bench -> grader -> protocol, sandbox <- checks.

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
target_compile_options(checking PRIVATE ${HOT})
target_link_libraries(checking PUBLIC sandbox protocol Catch2::Catch2WithMain)
file(GLOB sources CONFIGURE_DEPENDS autograder/measurements/support/*.cpp)
list(FILTER sources EXCLUDE REGEX "/speed_data[.]cpp$")
add_library(measuring STATIC ${sources})  # integrands are timed: the flags of submissions
own_target(measuring)
target_compile_options(measuring PRIVATE ${PROGRAM_FLAGS})
target_link_libraries(measuring PUBLIC checking)
add_custom_target(judge_all)  # what grade needs
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
    add_dependencies(${target} experiments_${lab} runner)  # what it asks for, it asks of a program
  endforeach()
endforeach()

# The grader: programs that share their verbs. What judges (a student waits for it), the gradebook,
# what draws, what benches. Libraries of objects, since a verb registers itself: nothing asks for it
# by name.
file(GLOB sources CONFIGURE_DEPENDS autograder/grader/context/*.cpp autograder/grader/submission/*.cpp
  autograder/grader/judging/*.cpp autograder/grader/reports/*.cpp)
list(FILTER sources EXCLUDE REGEX "(json|html|csv)[.]cpp$")
list(FILTER sources EXCLUDE REGEX "/sanitized[.]cpp$")
set(verbs check dispatch overview progress verb watch)
list(TRANSFORM verbs PREPEND autograder/grader/verbs/)
list(TRANSFORM verbs APPEND .cpp)
add_library(grading OBJECT ${sources} ${verbs})
own_target(grading)
target_link_libraries(grading PUBLIC sandbox protocol pugixml::pugixml Threads::Threads)
if(ARCHIVE_LIBRARY AND ARCHIVE_INCLUDE)
  target_compile_definitions(grading PRIVATE MC_HAVE_ARCHIVE)
  target_include_directories(grading PRIVATE ${ARCHIVE_INCLUDE})
  target_link_libraries(grading PUBLIC ${ARCHIVE_LIBRARY})
endif()

# What one does beside being judged.
set(verbs reset run setup submit test)
list(TRANSFORM verbs PREPEND autograder/grader/verbs/)
list(TRANSFORM verbs APPEND .cpp)
add_library(working OBJECT ${verbs} autograder/grader/submission/sanitized.cpp)
own_target(working)
target_link_libraries(working PUBLIC sandbox protocol)

# A check waits for no JSON library.
file(GLOB sources CONFIGURE_DEPENDS autograder/grader/verbs/*.cpp autograder/grader/gradebook/*.cpp)
list(FILTER sources EXCLUDE REGEX "/(check|demo|dispatch|overview|progress|reset|run|setup|submit|test|verb|watch|plot|render|report)[.]cpp$")
add_library(recording OBJECT autograder/grader/reports/csv.cpp autograder/grader/reports/json.cpp
  autograder/grader/reports/verdict_json.cpp ${sources})
own_target(recording)
in_parts(recording 8)
target_link_libraries(recording PUBLIC sandbox protocol nlohmann_json::nlohmann_json)

add_library(pages OBJECT autograder/grader/reports/html.cpp)
own_target(pages)
target_link_libraries(pages PUBLIC sandbox protocol)

file(GLOB sources CONFIGURE_DEPENDS autograder/grader/pictures/*.cpp)
add_library(drawing OBJECT ${sources} autograder/grader/verbs/demo.cpp autograder/grader/verbs/plot.cpp
  autograder/grader/verbs/render.cpp autograder/grader/verbs/report.cpp)
own_target(drawing)
target_link_libraries(drawing PUBLIC sandbox protocol)

set(programs grader desk gradebook pictures)
if(EXISTS ${CMAKE_SOURCE_DIR}/autograder/bench)
  list(APPEND programs bench)
  file(GLOB sources CONFIGURE_DEPENDS autograder/bench/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/measurement[.]cpp$")
  add_library(benching OBJECT ${sources})
  own_target(benching)
  in_parts(benching 4)
  target_link_libraries(benching PUBLIC sandbox protocol nlohmann_json::nlohmann_json)
endif()

set(without_json autograder/grader/reports/without_json.cpp)
add_executable(grader autograder/grader/main.cpp ${without_json})
add_executable(desk autograder/grader/main.cpp ${without_json})
add_executable(gradebook autograder/grader/main.cpp)
add_executable(pictures autograder/grader/main.cpp ${without_json})
if(TARGET benching)
  add_executable(bench autograder/grader/main.cpp ${without_json})
  target_link_libraries(bench PRIVATE drawing pages benching)
endif()
foreach(program ${programs})
  own_target(${program})
  target_link_libraries(${program} PRIVATE grading)
endforeach()
target_link_libraries(desk PRIVATE working)
target_link_libraries(gradebook PRIVATE recording pages)
target_link_libraries(pictures PRIVATE drawing pages)
add_dependencies(judge_all gradebook pictures)
