#pragma once
// Pictures: the requests of ./lab render, and the answers of hidden cases of lab 6.

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace mc::protocol {

/// The pictures that can be rendered, and the kinds of samplers: the others are compared with the
/// first. "[.render-list]" writes it, in two lines, to the file that render_variable names.
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

/// A request for one picture, in render_variable of "[.render]".
struct RenderRequest {
  std::string picture, kind;
  std::uint64_t spp = 0;
  double seconds = 0;  ///< CPU time limit of the second picture; 0: as much as the first took
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

/// A picture with a number of samples per pixel.
struct RenderErrors {
  std::uint64_t spp = 0;
  double seconds = 0;      ///< CPU time of the whole picture
  double rmse = 0;         ///< over its pixels
  double large_error = 0;  ///< 95 % of the pixels that are not exact have a smaller error
};
inline std::ostream& operator<<(std::ostream& file, const RenderErrors& result) {
  return file << result.spp << ' ' << result.seconds << ' ' << result.rmse << ' '
              << result.large_error << '\n';
}
inline std::istream& operator>>(std::istream& file, RenderErrors& result) {
  return file >> result.spp >> result.seconds >> result.rmse >> result.large_error;
}

}  // namespace mc::protocol
