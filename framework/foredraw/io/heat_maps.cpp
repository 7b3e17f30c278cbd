#include <foredraw/io/heat_maps.h>

#include <foredraw/analysis/heat_map.h>
#include <foredraw/io/private/picture.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace foredraw {

namespace {

using images::Colour;
using images::Picture;

constexpr Colour background = {18, 18, 22};
constexpr Colour ink = {225, 225, 230};

/// Of a pixel that is shaded once, twice, and so on; the last one from there on. Each step is told from the next by its
/// lightness or, for who sees all colours, by its hue.
constexpr std::array<Colour, 8> heat = {{{52, 62, 110},
                                         {42, 120, 142},
                                         {53, 183, 121},
                                         {190, 210, 60},
                                         {253, 180, 47},
                                         {236, 100, 60},
                                         {200, 40, 90},
                                         {255, 225, 255}}};

Colour colour_of(std::uint32_t times) {
  return times == 0 ? background : heat[std::min<std::size_t>(times, heat.size()) - 1];
}

constexpr int margin = 12;
constexpr int line = 26;  ///< of text in letters twice their size

void draw_map(Picture& picture, int x, int y, const HeatMap& map, int zoom) {
  std::size_t pixel = 0;
  for (int row = 0; row < map.size; ++row) {
    for (int column = 0; column < map.size; ++column, ++pixel) {
      if (map.times[pixel] == 0) continue;
      picture.fill(x + column * zoom, y + row * zoom, zoom, zoom, colour_of(map.times[pixel]));
    }
  }
}

void draw_legend(Picture& picture, int y) {
  const std::string text = "times shaded";
  picture.write(margin, y, text, ink, 2);
  int x = 2 * margin + Picture::width_of(text, 2);
  for (std::uint32_t times = 1; times <= heat.size(); ++times) {
    picture.fill(x, y - 4, 18, 18, colour_of(times));
    const std::string label = fmt::format("{}{}", times, times == heat.size() ? "+" : "");
    picture.write(x + 22, y, label, ink, 2);
    x += 22 + Picture::width_of(label, 2) + margin;
  }
}

std::string caption(const HeatMap& map) {
  return fmt::format("overdraw {:.3f}", static_cast<double>(map.count.shaded) / static_cast<double>(map.count.visible));
}

/// The maps side by side, what they are called above them, a legend below.
Picture drawn(const std::vector<HeatMap>& maps, const std::vector<std::string>& titles, const std::string& footer) {
  constexpr int least = 512;
  const int zoom = std::max(1, (least + maps[0].size - 1) / maps[0].size);
  const int edge = maps[0].size * zoom;
  const int panels = static_cast<int>(maps.size());
  Picture picture(panels * (edge + margin) + margin, margin + line + edge + margin + 2 * line, background);
  for (int i = 0; i < panels; ++i) {
    const int x = margin + i * (edge + margin);
    const auto panel = static_cast<std::size_t>(i);
    picture.write(x, margin, titles[panel] + caption(maps[panel]), ink, 2);
    draw_map(picture, x, margin + line, maps[panel], zoom);
  }
  draw_legend(picture, margin + line + edge + margin);
  picture.write(margin, margin + line + edge + margin + line, footer, ink, 1);
  return picture;
}

std::vector<DrawnSubject> all_drawn(const Scene& scene, Faces faces, const Executor& executor,
                                    Analyses& analyses) {
  const std::vector<Subject> subjects = subjects_of(scene);
  const PosedNodes nodes = posed_nodes(scene);
  std::vector<DrawnSubject> drawn(subjects.size());
  executor.for_each(subjects.size(),
                    [&](std::size_t i) { drawn[i] = drawn_subject(scene, subjects[i], faces, nodes, analyses); });
  return drawn;
}

double ratio_of(const OverdrawCount& count) {
  return count.visible == 0 ? 0 : static_cast<double>(count.shaded) / static_cast<double>(count.visible);
}

/// The view with the highest ratio, the first of them.
std::size_t worst_view(const DrawnSubject& subject, const Views& views, const Executor& executor) {
  std::vector<double> ratios(views.views.size());
  executor.for_each(ratios.size(), [&](std::size_t view) {
    ratios[view] = ratio_of(heat_map(subject.parts, views.views[view], views.size).count);
  });
  return static_cast<std::size_t>(std::ranges::max_element(ratios) - ratios.begin());
}

/// A name that any file system takes.
std::string as_file_name(const std::string& name) {
  std::string safe;
  for (const char c : name.substr(0, 80)) {
    const bool is_plain =
        (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' || c == '_';
    safe += is_plain ? c : '_';
  }
  return safe.empty() ? "subject" : safe;
}

std::optional<std::size_t> number_in(const std::string& text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

}  // namespace

bool are_views(const std::string& which, const OverdrawOptions& options, Diagnostics& diagnostics) {
  const std::size_t count = make_views(options).views.size();
  const std::optional<std::size_t> number = number_in(which);
  if (which == "worst" || which == "all" || (number && *number < count)) return true;
  diagnostics.error({}, "bad-arguments", fmt::format("there is no view '{}' to draw", which),
                    fmt::format("worst, all, or a number from 0 to {}", count - 1));
  return false;
}

std::vector<OutputFile> heat_maps(const Scene& before, const Scene* after, const OverdrawOptions& options,
                                  const std::string& which, const std::filesystem::path& folder,
                                  const Executor& executor, Analyses& analyses) {
  const Views views = make_views(options);
  const std::optional<std::size_t> number = number_in(which);
  const std::vector<Subject> subjects = subjects_of(before);
  const std::vector<DrawnSubject> old_ones = all_drawn(before, options.faces, executor, analyses);
  std::vector<DrawnSubject> new_ones;
  if (after != nullptr) new_ones = all_drawn(*after, options.faces, executor, analyses);

  struct Shot {
    std::size_t subject, view;
  };
  std::vector<Shot> shots;
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    if (which == "all") {
      for (std::size_t view = 0; view < views.views.size(); ++view) shots.push_back({i, view});
    } else {
      shots.push_back({i, number ? *number : worst_view(old_ones[i], views, executor)});
    }
  }
  std::vector<OutputFile> files(shots.size());
  executor.for_each(shots.size(), [&](std::size_t i) {
    const auto [subject, view] = shots[i];
    const View& from = views.views[view];
    std::vector<HeatMap> maps = {heat_map(old_ones[subject].parts, from, views.size)};
    std::vector<std::string> titles = {""};
    if (maps[0].count.visible == 0) return;
    if (subject < new_ones.size()) {
      maps.push_back(heat_map(new_ones[subject].parts, from, views.size));
      titles = {"before: ", "after: "};
    }
    const std::string footer =
        fmt::format("{}, view {} of {}, from ({:.3f}, {:.3f}, {:.3f})", subjects[subject].name, view,
                    views.views.size(), from.direction.x, from.direction.y, from.direction.z);
    files[i] = {folder / fmt::format("{:03}-{}-view{:03}.png", subject, as_file_name(subjects[subject].name), view),
                drawn(maps, titles, footer).as_png()};
  });
  std::erase_if(files, [](const OutputFile& file) { return file.bytes.empty(); });
  return files;
}

}  // namespace foredraw
