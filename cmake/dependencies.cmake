# The project's dependencies. The system's packages come first; where one is missing, its source at
# a known-good version (this needs the network; ./lab setup installs packages instead).
include(FetchContent)

# dependency(<package> <target> <repository> <tag>)
macro(dependency package target repository tag)
  find_package(${package} QUIET)
  if(NOT TARGET ${target})
    message(STATUS "${package} is not installed: fetching ${tag}")
    FetchContent_Declare(${package} GIT_REPOSITORY ${repository} GIT_TAG ${tag} GIT_SHALLOW ON)
    FetchContent_MakeAvailable(${package})
  endif()
endmacro()

dependency(Catch2 Catch2::Catch2WithMain https://github.com/catchorg/Catch2 v3.5.4)
dependency(fmt fmt::fmt https://github.com/fmtlib/fmt 10.2.1)
dependency(nlohmann_json nlohmann_json::nlohmann_json https://github.com/nlohmann/json v3.11.3)
find_package(Threads REQUIRED)

# Without libseccomp the jail is incomplete, and every grade says so.
find_library(SECCOMP_LIBRARY seccomp)
find_library(SECCOMP_STATIC_LIBRARY libseccomp.a)
find_path(SECCOMP_INCLUDE seccomp.h)

# Without libarchive, zips must be unpacked by hand.
find_library(ARCHIVE_LIBRARY archive)
find_path(ARCHIVE_INCLUDE archive.h)

# Libraries that the labs are compared with: one folder each in autograder/submissions/peers. Its
# find.cmake sets PEER_FOUND, and PEER_LINK to the libraries to link. The comparison with a missing
# library is skipped.
set(LAYOUT_PEERS)
set(PEER_LIBRARIES)
set(PEER_DEFINITIONS)
set(PEER_PREFIX lib)  # programs are static
set(PEER_SUFFIX .a)
file(GLOB finds CONFIGURE_DEPENDS autograder/submissions/peers/*/find.cmake)
foreach(find ${finds})
  cmake_path(GET find PARENT_PATH folder)
  cmake_path(GET folder FILENAME peer)
  set(PEER_FOUND)
  set(PEER_LINK)
  include(${find})
  if(PEER_FOUND)
    list(APPEND PEER_LIBRARIES ${PEER_LINK})
    string(TOUPPER ${peer} upper)
    list(APPEND PEER_DEFINITIONS MC_HAVE_${upper})
    list(APPEND LAYOUT_PEERS "\"${peer}\": [\"$<JOIN:${PEER_LINK},\", \">\"]")
  endif()
endforeach()

# Programs that judge nothing: looked for when they are used.
find_program(GIT git)
