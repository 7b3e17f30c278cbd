#include <foredraw/page/heat_maps.h>

#include <foredraw/base/whole_number.h>
#include <foredraw/io/image/picture.h>
#include <foredraw/measuring/subjects_in_poses.h>
#include <foredraw/overdraw/heat_map.h>
#include <foredraw/viewing/drawn_orders.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

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

double ratio_of(const OverdrawCount& count) {
  return count.visible == 0 ? 0 : static_cast<double>(count.shaded) / static_cast<double>(count.visible);
}

/// Draws subjects as they look in one of the poses, in the orders that their tables give there.
class Photographer {
 public:
  Photographer(const SubjectsInPoses& subjects, const Views& views, const OverdrawOptions& options, Analyses& analyses)
      : subjects_(subjects), views_(views), faces_(options.faces), said_by_(options.sequence), analyses_(analyses) {}

  HeatMap map(const Scene& scene, std::size_t subject, std::size_t pose, std::size_t view) const {
    const View& from = views_.views[view];
    const Subject& whole = subjects_.subjects[subject];
    const SubjectGeometry posed = geometry(scene, subject, pose);
    const auto orders = views_by_orders(scene, whole, subjects_.poses.poses[pose], {&from, 1}, said_by_);
    return heat_map(parts_as_drawn(posed, scene, whole, orders.front()), from, views_.size);
  }

  struct Look {
    std::size_t pose = 0;
    double ratio = 0;
  };

  /// [view] the pose in which it has the highest ratio, the first of them.
  std::vector<Look> worst_poses(std::size_t subject, const Executor& executor) const {
    std::vector<Look> worst(views_.views.size());
    for (std::size_t pose = 0; pose < subjects_.poses.poses.size(); ++pose) {
      if (!subjects_.is_new(subject, pose)) continue;
      const Subject& whole = subjects_.subjects[subject];
      const SubjectGeometry posed = geometry(subjects_.scene, subject, pose);
      for (const ViewsOfOrders& some :
           views_by_orders(subjects_.scene, whole, subjects_.poses.poses[pose], views_.views, said_by_)) {
        const std::vector<RasterPart> drawn = parts_as_drawn(posed, subjects_.scene, whole, some);
        executor.for_each(some.views.size(), [&](std::size_t i) {
          const std::size_t view = some.views[i];
          const double ratio = ratio_of(heat_map(drawn, views_.views[view], views_.size).count);
          if (ratio > worst[view].ratio) worst[view] = {pose, ratio};
        });
      }
    }
    return worst;
  }

 private:
  SubjectGeometry geometry(const Scene& scene, std::size_t subject, std::size_t pose) const {
    return subject_geometry(scene, subjects_.subjects[subject], faces_, posed_nodes(scene, subjects_.poses.poses[pose]),
                            analyses_);
  }

  const SubjectsInPoses& subjects_;
  const Views& views_;
  Faces faces_;
  SequenceFrom said_by_;
  Analyses& analyses_;
};

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

}  // namespace

bool are_views(const std::string& which, const OverdrawOptions& options, Diagnostics& diagnostics) {
  const auto count = static_cast<std::int64_t>(make_views(options).views.size());
  const auto number = whole_number(which);
  if (which == "worst" || which == "all" || (number && *number >= 0 && *number < count)) return true;
  diagnostics.error({}, "bad-arguments", fmt::format("there is no view '{}'", which),
                    fmt::format("give worst, all, or a number from 0 to {}", count - 1));
  return false;
}

std::vector<OutputFile> heat_maps(const Scene& before, const Scene* after, const OverdrawOptions& options,
                                  const std::string& which, const std::filesystem::path& folder,
                                  const Executor& executor, Analyses& analyses) {
  const Views views = make_views(options);
  const auto number = whole_number(which);
  SubjectsInPoses subjects{before, subjects_of(before, options.subject), make_poses(before, options), {}};
  subjects.distinct = distinct_poses(before, subjects.subjects, subjects.poses, executor);
  const Photographer photographer(subjects, views, options, analyses);

  struct Shot {
    std::size_t subject, pose, view;
  };
  std::vector<Shot> shots;
  for (std::size_t i = 0; i < subjects.subjects.size(); ++i) {
    const auto looks = photographer.worst_poses(i, executor);
    const auto worst = std::ranges::max_element(looks, {}, &Photographer::Look::ratio) - looks.begin();
    for (std::size_t view = 0; view < looks.size(); ++view) {
      const bool is_wanted = which == "all" || static_cast<std::int64_t>(view) == number.value_or(worst);
      if (is_wanted && looks[view].ratio > 0) shots.push_back({i, looks[view].pose, view});
    }
  }
  const std::vector<std::string> clips = clip_names(before);
  std::vector<OutputFile> files(shots.size());
  executor.for_each(shots.size(), [&](std::size_t i) {
    const auto [subject, pose, view] = shots[i];
    std::vector<HeatMap> maps = {photographer.map(before, subject, pose, view)};
    std::vector<std::string> titles = {""};
    if (after != nullptr) {
      maps.push_back(photographer.map(*after, subject, pose, view));
      titles = {"before: ", "after: "};
    }
    const std::string& name = subjects.subjects[subject].name;
    const std::string moment = pose_name(subjects.poses.poses[pose], clips);
    const bool has_poses = subjects.moves(subject);
    const glm::dvec3& from = views.views[view].direction;
    const std::string footer =
        fmt::format("{}{}, view {} of {}, from ({:.3f}, {:.3f}, {:.3f})", name, has_poses ? " in " + moment : "", view,
                    views.views.size(), from.x, from.y, from.z);
    const std::string file = fmt::format("{:03}-{}{}-view{:03}.png", subject, as_file_name(name),
                                         has_poses ? "-" + as_file_name(moment) : "", view);
    files[i] = {folder / file, drawn(maps, titles, footer).as_png()};
  });
  return files;
}

}  // namespace foredraw
