#include "clip.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace foredraw::bench {

namespace {

using Json = GltfDocument::Json;

std::vector<float> floats_of(const GltfDocument::Opened& file, std::size_t number) {
  const Json& accessor = file.json.at("accessors").at(number);
  if (accessor.at("componentType") != 5126) throw std::runtime_error(file.name + ": a clip is not of floats");
  const std::string type = accessor.at("type");
  const std::size_t width = type == "SCALAR" ? 1 : static_cast<std::size_t>(type[3] - '0');
  const std::size_t count = accessor.at("count").get<std::size_t>() * width;
  const std::size_t offset = accessor.value("byteOffset", std::size_t{0});
  const auto bytes = file.view(accessor.at("bufferView").get<std::size_t>());
  if (offset > bytes.size() || count > (bytes.size() - offset) / 4) {
    throw std::runtime_error(file.name + ": a clip does not lie in its view");
  }
  std::vector<float> values(count);
  std::memcpy(values.data(), bytes.data() + offset, 4 * count);
  return values;
}

}  // namespace

Clip::Clip(const GltfDocument::Opened& file, const std::string& name) {
  const Json& animations = file.json.at("animations");
  const auto found = std::ranges::find_if(animations, [&](const Json& a) { return a.value("name", "") == name; });
  if (found == animations.end()) throw std::runtime_error(file.name + ": it has no clip '" + name + "'");
  for (const Json& channel : found->at("channels")) {
    Track track{channel.at("target").at("node"), channel["target"].at("path"), 3, {}, {}, false};
    if (track.path == "weights") continue;
    if (track.path == "rotation") track.width = 4;
    const Json& sampler = found->at("samplers").at(channel.at("sampler").get<std::size_t>());
    track.times = floats_of(file, sampler.at("input"));
    track.values = floats_of(file, sampler.at("output"));
    for (std::size_t i = track.width; i < track.values.size(); ++i) {
      track.moves = track.moves || std::abs(track.values[i] - track.values[i % track.width]) > 1e-5f;
    }
    seconds_ = std::max(seconds_, static_cast<double>(track.times.back()));
    tracks_.push_back(std::move(track));
  }
}

void Clip::add_value(const Track& track, double time, std::vector<float>& to) {
  const auto above = std::ranges::upper_bound(track.times, static_cast<float>(time));
  const auto next =
      static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - track.times.begin(), 0, std::ssize(track.times) - 1));
  const std::size_t last = next == 0 ? 0 : next - 1;
  const double start = track.times[last], span = track.times[next] - start;
  const double part = span > 0 ? std::clamp((time - start) / span, 0.0, 1.0) : 0;
  double between[4] = {}, dot = 0, length = 0;
  const float *a = track.values.data() + last * track.width, *b = track.values.data() + next * track.width;
  for (std::size_t k = 0; k < track.width; ++k) dot += static_cast<double>(a[k]) * b[k];
  const bool is_turn = track.width == 4;
  for (std::size_t k = 0; k < track.width; ++k) {
    const double end = is_turn && dot < 0 ? -b[k] : b[k];
    between[k] = a[k] + part * (end - a[k]);
    length += between[k] * between[k];
  }
  for (std::size_t k = 0; k < track.width; ++k) {
    to.push_back(static_cast<float>(is_turn ? between[k] / std::sqrt(length) : between[k]));
  }
}

}  // namespace foredraw::bench
