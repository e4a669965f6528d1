// All of fmt, from its headers (handout.cmake).
#define FMT_HEADER_ONLY
#include <fmt/format.h>
