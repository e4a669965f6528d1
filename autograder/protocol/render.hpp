#pragma once
// One picture, as ./lab render asks for it and as a hidden case of lab 6 answers.

#include <cstdint>
#include <sstream>
#include <string>

namespace mc::protocol {

/// Asked for in render_variable.
struct RenderRequest {
  std::string picture, kind;
  std::uint64_t spp = 0;
  double seconds = 0;  ///< the CPU time that the second picture may take; 0: as much as the first
};
inline std::string text_of(const RenderRequest& request) {
  std::ostringstream text;
  text.precision(17);
  text << request.picture << ' ' << request.kind << ' ' << request.spp << ' ' << request.seconds;
  return text.str();
}
inline RenderRequest render_request_in(const std::string& text) {
  RenderRequest request;
  std::istringstream(text) >> request.picture >> request.kind >> request.spp >> request.seconds;
  return request;
}

/// A picture with a number of samples a pixel.
struct RenderFigures {
  std::uint64_t spp = 0;
  double seconds = 0;      ///< CPU time of the whole picture
  double rmse = 0;         ///< over its pixels
  double large_error = 0;  ///< 95 % of the pixels that are not exact are nearer than this
};
inline std::ostream& operator<<(std::ostream& file, const RenderFigures& figures) {
  return file << figures.spp << ' ' << figures.seconds << ' ' << figures.rmse << ' '
              << figures.large_error << '\n';
}
inline std::istream& operator>>(std::istream& file, RenderFigures& figures) {
  return file >> figures.spp >> figures.seconds >> figures.rmse >> figures.large_error;
}

}  // namespace mc::protocol
