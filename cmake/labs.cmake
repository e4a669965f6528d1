# The common parts of a submission's program, compiled once: the runner and each lab's experiments.
# Labs are the folders labs/N-name.

# After the CXXFLAGS of the environment: a submission is linked with these objects.
set(PROGRAM_FLAGS -O3 -ffp-contract=off -fno-lto -fno-sanitize=all)
if(CMAKE_SYSTEM_NAME STREQUAL Linux AND NOT CMAKE_BUILD_TYPE STREQUAL Debug)
  set(PROGRAM_LINK_FLAGS -static)  # programs need no loader, and the jail no open()
  file(WRITE ${CMAKE_BINARY_DIR}/static.cpp "#include <vector>\nint main() { std::vector<int> x(1); return x[0]; }\n")
  try_compile(LINKS_STATICALLY ${CMAKE_BINARY_DIR} ${CMAKE_BINARY_DIR}/static.cpp LINK_OPTIONS -static)
  if(NOT LINKS_STATICALLY)
    message(FATAL_ERROR "No static C and C++ library: install glibc-static and libstdc++-static (dnf), "
      "or libc6-dev and the compiler's libstdc++ package (apt)")
  endif()
endif()

add_library(runner OBJECT labs/runner/main.cpp labs/runner/list.cpp labs/runner/table.cpp
  labs/runner/text.cpp)
target_include_directories(runner PUBLIC labs)
target_compile_options(runner PRIVATE ${PROGRAM_FLAGS} -O1)  # not performance-critical
with_warnings(runner)
if(MC_UNITY)
  set_target_properties(runner PROPERTIES UNITY_BUILD ON)
endif()

file(GLOB LAB_FOLDERS CONFIGURE_DEPENDS LIST_DIRECTORIES ON RELATIVE ${CMAKE_SOURCE_DIR}/labs
  labs/[0-9]*-*)
foreach(folder ${LAB_FOLDERS})
  string(REGEX REPLACE "^[0-9]+-" "" lab ${folder})
  string(REPLACE "-" "_" lab ${lab})
  list(APPEND LABS ${lab})
  set(LAB_INCLUDES ${LAB_INCLUDES} ${CMAKE_SOURCE_DIR}/labs/${folder})

  add_library(experiments_${lab} OBJECT labs/${folder}/experiments.cpp)
  target_include_directories(experiments_${lab} PRIVATE labs ${LAB_INCLUDES})
  target_compile_options(experiments_${lab} PRIVATE ${PROGRAM_FLAGS})
  with_warnings(experiments_${lab})
  list(APPEND LAYOUT_OBJECTS "\"${lab}\": [\"$<JOIN:$<TARGET_OBJECTS:experiments_${lab}>;$<TARGET_OBJECTS:runner>,\", \">\"]")

  # Starters and solutions in compile_commands.json, for clangd. Nothing runs these programs.
  foreach(who starter solutions)
    file(GLOB files CONFIGURE_DEPENDS ${who}/${lab}.cpp)
    if(files)
      set(program ${who}-${lab})
      set(${who}_FILES ${${who}_FILES} ${files})
      add_executable(${program} EXCLUDE_FROM_ALL ${${who}_FILES})
      target_link_libraries(${program} PRIVATE experiments_${lab} runner)
      target_include_directories(${program} PRIVATE labs ${LAB_INCLUDES})
    endif()
  endforeach()
endforeach()

set(is_clang false)
if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
  set(is_clang true)
endif()
set(sanitized false)
if(MC_SANITIZE OR CMAKE_CXX_FLAGS MATCHES -fsanitize)
  set(sanitized true)
endif()
# Where everything is, for the program (autograder/judge/checkout/layout.cpp).
list(JOIN LAYOUT_OBJECTS ",\n  " LAYOUT_OBJECTS)
list(JOIN LAYOUT_PEERS ",\n  " LAYOUT_PEERS)
file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/layout.json CONTENT "{
 \"root\": \"${CMAKE_SOURCE_DIR}\",
 \"version\": \"${PROJECT_VERSION}\",
 \"sanitized\": ${sanitized},
 \"compiler\": \"${CMAKE_CXX_COMPILER}\",
 \"is_clang\": ${is_clang},
 \"link_flags\": [\"$<JOIN:${PROGRAM_LINK_FLAGS},\", \">\"],
 \"objects\": {
  ${LAYOUT_OBJECTS}},
 \"peers\": {
  ${LAYOUT_PEERS}}
}
")
