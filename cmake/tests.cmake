# The repository proves itself: `ctest`, or `./lab test`.
enable_testing()

file(GLOB sources CONFIGURE_DEPENDS autograder/tests/*_test.cpp)
add_executable(grader_tests EXCLUDE_FROM_ALL ${sources})
target_link_libraries(grader_tests PRIVATE grading recording drawing benching checking_figures)
target_include_directories(grader_tests PRIVATE ${LAB_INCLUDES})
target_compile_definitions(grader_tests PRIVATE MC_LAB="${CMAKE_SOURCE_DIR}/lab")
add_test(NAME grader COMMAND grader_tests)

# Every submission of the repository, with what its first lines say must happen to it.
add_executable(self_test EXCLUDE_FROM_ALL autograder/tests/self_test.cpp
  autograder/checks/support/distributions.cpp autograder/grader/reports/without_json.cpp)
target_link_libraries(self_test PRIVATE grading)
own_target(self_test)
own_target(grader_tests)
add_test(NAME repository COMMAND self_test repository)
foreach(lab ${LABS})
  foreach(who starter solutions)
    if(EXISTS ${CMAKE_SOURCE_DIR}/${who}/${lab}.cpp)
      add_test(NAME ${who}/${lab} COMMAND self_test ${who}/${lab}.cpp WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
    endif()
  endforeach()
endforeach()
file(GLOB_RECURSE submissions CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}/autograder/submissions
  autograder/submissions/*.cpp)
foreach(file ${submissions})
  string(REGEX REPLACE "[.]cpp$" "" name ${file})
  add_test(NAME ${name} COMMAND self_test autograder/submissions/${file}
    WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
endforeach()

# With a thousand seeds (./lab test --full) one of them takes the better part of an hour.
get_property(tests DIRECTORY PROPERTY TESTS)
set_tests_properties(${tests} PROPERTIES TIMEOUT 36000 SKIP_RETURN_CODE 77)
