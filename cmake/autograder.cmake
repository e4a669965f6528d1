# The judge: the sandbox, the protocol, the checks of each lab, the grader, the bench. Includes point
# downwards only: bench -> grader -> protocol, sandbox <- checks.

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

# Checks: what every lab's share, then two programs a lab: what judges, and what measures for plots
# and bench, which nobody waits for.
file(GLOB sources CONFIGURE_DEPENDS autograder/checks/support/*.cpp)
set(timed autograder/checks/support/integrands.cpp)
list(FILTER sources EXCLUDE REGEX integrands)
add_library(checking STATIC ${sources})
own_target(checking)
target_compile_options(checking PRIVATE ${HOT})
target_link_libraries(checking PUBLIC sandbox protocol Catch2::Catch2WithMain)
add_library(checking_figures STATIC ${timed})  # its time is measured: flags as programs have them
own_target(checking_figures)
target_compile_options(checking_figures PRIVATE ${PROGRAM_FLAGS})
add_custom_target(judge_all)  # what grade needs
foreach(lab ${LABS})
  file(GLOB sources CONFIGURE_DEPENDS autograder/checks/${lab}/*.cpp)
  set(figures ${sources})
  list(FILTER sources EXCLUDE REGEX "/(plots|bench|render)[a-z_]*[.]cpp$")
  list(FILTER figures INCLUDE REGEX "/(plots|bench|render)[a-z_]*[.]cpp$")
  add_executable(checks_${lab} ${sources})
  add_executable(figures_${lab} ${figures})
  foreach(target checks_${lab} figures_${lab})
    own_target(${target})
    target_compile_options(${target} PRIVATE ${HOT})
    target_include_directories(${target} PRIVATE ${LAB_INCLUDES})
    target_link_libraries(${target} PRIVATE checking checking_figures)
    add_dependencies(judge_all ${target})
    add_dependencies(${target} experiments_${lab} runner)  # what it asks for, it asks of a program
  endforeach()
endforeach()

# The grader, three programs that share the verbs: what judges, what draws, what benches.
file(GLOB sources CONFIGURE_DEPENDS autograder/grader/context/*.cpp autograder/grader/submission/*.cpp
  autograder/grader/judging/*.cpp autograder/grader/reports/*.cpp autograder/grader/verbs/verb.cpp
  autograder/grader/verbs/progress.cpp)
list(FILTER sources EXCLUDE REGEX "json[.]cpp$")
add_library(grading STATIC ${sources})
own_target(grading)
target_link_libraries(grading PUBLIC sandbox protocol pugixml::pugixml
  Threads::Threads)
file(GLOB sources CONFIGURE_DEPENDS autograder/grader/pictures/*.cpp)
add_library(drawing STATIC ${sources})
own_target(drawing)
target_link_libraries(drawing PUBLIC grading)

# A check waits for no JSON library: what needs it is the gradebook, which has all the others' verbs.
add_library(json_report STATIC autograder/grader/reports/json.cpp)
own_target(json_report)
target_link_libraries(json_report PUBLIC grading nlohmann_json::nlohmann_json)

file(GLOB verbs CONFIGURE_DEPENDS autograder/grader/verbs/*.cpp)
list(FILTER verbs EXCLUDE REGEX "/(verb|progress)[.]cpp$")
set(drawing_verbs ${verbs})
list(FILTER drawing_verbs INCLUDE REGEX "/(plot|render)[.]cpp$")
list(REMOVE_ITEM verbs ${drawing_verbs})
set(student_verbs ${verbs})
list(FILTER student_verbs INCLUDE REGEX "/(check|overview|reset|run|setup|submit|test)[.]cpp$")
set(without_json autograder/grader/reports/without_json.cpp)
add_executable(grader autograder/grader/main.cpp ${student_verbs} ${without_json})
add_executable(gradebook autograder/grader/main.cpp ${verbs})
add_executable(pictures autograder/grader/main.cpp ${drawing_verbs} ${without_json})
target_link_libraries(grader PRIVATE grading)
target_link_libraries(gradebook PRIVATE json_report)
target_link_libraries(pictures PRIVATE drawing)
add_dependencies(judge_all gradebook pictures)

file(GLOB sources CONFIGURE_DEPENDS autograder/bench/*.cpp)
list(FILTER sources EXCLUDE REGEX "/(measurement|ratios)[.]cpp$")
add_library(benching STATIC ${sources})
list(FILTER sources INCLUDE REGEX "/run[.]cpp$")
add_executable(bench autograder/grader/main.cpp ${sources})
target_link_libraries(bench PRIVATE benching)
own_target(benching)
target_link_libraries(benching PUBLIC drawing json_report)
foreach(program grader gradebook pictures bench)
  own_target(${program})
endforeach()
