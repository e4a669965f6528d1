#pragma once
// Pictures, as ./lab render asks for them and as hidden cases of lab 6 answer.

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace mc::protocol {

/// What there is to render, and by which kinds of samplers: the first is what the others are
/// compared with. "[.render-list]" writes it, in two lines, to the file that render_variable names.
struct RenderList {
  std::vector<std::string> pictures, kinds;
};
inline std::ostream& operator<<(std::ostream& file, const RenderList& list) {
  for (const auto& names : {list.pictures, list.kinds}) {
    for (const std::string& name : names) file << name << ' ';
    file << '\n';
  }
  return file;
}
inline std::istream& operator>>(std::istream& file, RenderList& list) {
  for (std::vector<std::string>* const names : {&list.pictures, &list.kinds}) {
    std::string line, name;
    std::getline(file, line);
    for (std::istringstream words(line); words >> name;) names->push_back(name);
  }
  return file;
}

/// One picture, asked for in render_variable of "[.render]".
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
