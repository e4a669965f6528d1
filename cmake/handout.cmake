# The judge of a handout: the same objects as everywhere else, linked statically, so that students
# need neither the sources nor the libraries. ./lab handout copies build/handout. Linux only.
set(HANDOUT_LINKS no)
get_target_property(fmt_type fmt::fmt TYPE)
if(NOT MC_SANITIZE AND SECCOMP_STATIC_LIBRARY
    AND (CMAKE_CXX_COMPILER_ID STREQUAL GNU OR NOT fmt_type STREQUAL SHARED_LIBRARY))
  set(HANDOUT_LINKS yes)
endif()
add_custom_target(handout_judge ALL)
if(NOT HANDOUT_LINKS)
  return()
endif()

# Distributions ship fmt as a shared library only, with all the headers: one file with every function
# of theirs is the static library.
set(static_fmt fmt::fmt)
if(fmt_type STREQUAL SHARED_LIBRARY)
  add_library(static_fmt STATIC EXCLUDE_FROM_ALL cmake/static_fmt.cpp)
  target_compile_options(static_fmt PRIVATE -O1 -fkeep-inline-functions -ffunction-sections)
  set(static_fmt static_fmt)
endif()

# static_judge(<program> <target>...): links the objects of these targets into build/handout/<program>.
function(static_judge program)
  list(TRANSFORM ARGN REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>" OUTPUT_VARIABLE objects)
  add_executable(handout_${program} EXCLUDE_FROM_ALL ${objects})
  add_dependencies(handout_judge handout_${program})
  set_target_properties(handout_${program} PROPERTIES OUTPUT_NAME ${program} LINKER_LANGUAGE CXX
    RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/handout)
  target_link_options(handout_${program} PRIVATE -static -s -Wl,--gc-sections
    $<$<BOOL:${MC_COVERAGE}>:--coverage>)
endfunction()
set(below $<TARGET_FILE:protocol> $<TARGET_FILE:sandbox> ${static_fmt} ${SECCOMP_STATIC_LIBRARY}
  Threads::Threads)

# Without libarchive, which needs a dozen other libraries: students hand in zips and receive none.
static_judge(lab lab judge)
target_sources(handout_lab PRIVATE autograder/judge/submission/archive.cpp)
target_include_directories(handout_lab PRIVATE autograder labs)
target_link_libraries(handout_lab PRIVATE ${below})
foreach(lab ${LABS})
  static_judge(checks_${lab} checks_${lab})
  target_link_libraries(handout_checks_${lab} PRIVATE $<TARGET_FILE:checking> ${below}
    Catch2::Catch2WithMain)
  get_target_property(kind measure_${lab} TYPE)
  if(kind STREQUAL EXECUTABLE)
    static_judge(measure_${lab} measure_${lab})
    target_link_libraries(handout_measure_${lab} PRIVATE $<TARGET_FILE:measuring>
      $<TARGET_FILE:checking> ${below} Catch2::Catch2WithMain)
  endif()
endforeach()
