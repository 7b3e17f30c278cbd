#include <foredraw/pipeline/ranges.h>

#include <foredraw/pipeline/answers.h>

#include <algorithm>
#include <numeric>

namespace foredraw {

namespace {

Shared<std::uint32_t> part_of(const Shared<std::uint32_t>& values, std::size_t first, std::size_t end) {
  if (values.empty()) return {};
  return Shared<std::uint32_t>({values.view().begin() + static_cast<std::ptrdiff_t>(first),
                                values.view().begin() + static_cast<std::ptrdiff_t>(end)});
}

Clusters part_of(const Clusters& clusters, std::uint32_t first, std::uint32_t end) {
  Clusters part{{0}};
  for (const std::uint32_t offset : clusters.offsets) {
    if (offset > first && offset < end) part.offsets.push_back(offset - first);
  }
  part.offsets.push_back(end - first);
  return part;
}

/// The draw's triangles from `first` on, in the order that stands alone.
Draw part_of(const Draw& draw, std::uint32_t first, std::uint32_t end) {
  Draw part = draw;
  part.full().orders.resize(1);
  const IndexStream& whole = draw.full().stream();
  IndexStream& stream = part.full().stream();
  stream.indices = part_of(whole.indices, 3 * std::size_t{first}, 3 * std::size_t{end});
  stream.triangle_origin = part_of(whole.triangle_origin, first, end);
  if (whole.clusters) stream.clusters = part_of(*whole.clusters, first, end);
  return part;
}

IndexOrder as_it_is(std::size_t triangles) {
  IndexOrder order(triangles);
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

/// Calls each(range, its first triangle).
template <class Each>
void each_range(DrawId draw, const RangedScene& in, Run& run, Each each) {
  std::optional<std::string> why_all_are_kept;
  bool is_any_changed = false;
  std::uint32_t first = 0;
  for (const DrawId id : in.ranges[draw]) {
    const DrawView range{in.scene, id};
    run.findings.nothing_to_gain.reset();
    each(range, first);
    is_any_changed = is_any_changed || !run.keeps();
    if (run.keeps()) why_all_are_kept = run.findings.nothing_to_gain;
    first += static_cast<std::uint32_t>(range.triangle_count());
  }
  run.findings.nothing_to_gain = is_any_changed ? std::nullopt : why_all_are_kept;
}

}  // namespace

std::optional<RangedScene> RangedScene::of(const Scene& scene, const Scene& whole, std::size_t level,
                                           const ProductRows& rows) {
  std::optional<RangedScene> in;
  for (DrawId id = 0; id < scene.draws.size(); ++id) {
    const Draw& draw = scene.draws[id];
    if (draw.topology != Topology::triangles || level >= whole.draws[id].levels.size()) continue;
    std::vector<std::uint32_t> ends = bounds_of(whole, {id, level}, rows);
    if (ends.empty()) continue;
    const auto triangles = static_cast<std::uint32_t>(draw.full().stream().triangle_count());
    if (!in) {
      in = RangedScene{scene, {}};
      in->scene.products = {};  // they know no draws but whole ones
      for (DrawId every = 0; every < scene.draws.size(); ++every) in->ranges.push_back({every});
    }
    in->scene.draws[id] = part_of(draw, 0, ends.front());
    ends.push_back(triangles);
    for (std::size_t i = 1; i < ends.size(); ++i) {
      in->ranges[id].push_back(static_cast<DrawId>(in->scene.draws.size()));
      in->scene.draws.push_back(part_of(draw, ends[i - 1], ends[i]));
    }
  }
  return in;
}

void cut_clusters(Scene& scene, const ProductRows& rows) {
  for (DrawId id = 0; !scene.products.empty() && id < scene.draws.size(); ++id) {
    for (std::size_t level = 0; level < scene.draws[id].levels.size(); ++level) {
      IndexStream& stream = scene.draws[id].levels[level].stream();
      if (!stream.clusters) continue;
      const auto bounds = bounds_of(scene, {id, level}, rows);
      std::vector<std::uint32_t> offsets;
      std::ranges::set_union(stream.clusters->offsets, bounds, std::back_inserter(offsets));
      stream.clusters->offsets = std::move(offsets);
    }
  }
}

IndexOrder order_of(const DrawOrderer& technique, DrawId draw, const RangedScene& in, Run& run) {
  IndexOrder whole;
  each_range(draw, in, run, [&](const DrawView& range, std::uint32_t first) {
    IndexOrder order = technique.order(range, run);
    if (run.keeps()) order = as_it_is(range.triangle_count());
    check_order(order, range.triangle_count(), "triangles");
    for (const std::uint32_t triangle : order) whole.push_back(first + triangle);
  });
  return whole;
}

Clusters clusters_of(const Clusterer& technique, DrawId draw, const RangedScene& in, Run& run) {
  Clusters whole{{0}};
  each_range(draw, in, run, [&](const DrawView& range, std::uint32_t first) {
    const Clusters clusters = technique.cluster(range, run);
    check_clusters(clusters, range.triangle_count());
    for (std::size_t i = 1; i < clusters.offsets.size(); ++i) whole.offsets.push_back(first + clusters.offsets[i]);
  });
  return whole;
}

SubjectOrders orders_of(const SubjectOrderer& technique, const SubjectView& subject, const RangedScene& in, Run& run) {
  Subject parted{subject.subject.name, {}};
  for (const SubjectPart& part : subject.subject.parts) {
    for (const DrawId range : in.ranges[part.draw]) parted.parts.push_back({range, part.node});
  }
  SubjectView view{in.scene, parted, {}};
  for (const DrawId id : subject.draws) {
    view.draws.insert(view.draws.end(), in.ranges[id].begin(), in.ranges[id].end());
  }
  SubjectOrders answer = technique.order(view, run);
  if (run.keeps()) return answer;
  check_orders(view, answer);

  SubjectOrders whole{{}, answer.table, {}};
  whole.table.draws.clear();
  const auto number_of = [&](DrawId range) {
    return static_cast<std::size_t>(std::ranges::find(answer.table.draws, range) - answer.table.draws.begin());
  };
  for (const DrawId id : subject.draws) {
    const auto is_ordered = [&](DrawId range) { return number_of(range) < answer.orders.size(); };
    if (std::ranges::none_of(in.ranges[id], is_ordered)) continue;
    std::vector<IndexOrder> orders(answer.orders.front().size());
    std::uint32_t first = 0;
    for (const DrawId range : in.ranges[id]) {
      const std::size_t triangles = in.scene.draws[range].full().stream().triangle_count();
      for (std::size_t j = 0; j < orders.size(); ++j) {
        const IndexOrder order = is_ordered(range) ? answer.orders[number_of(range)][j] : as_it_is(triangles);
        for (const std::uint32_t triangle : order) orders[j].push_back(first + triangle);
      }
      first += static_cast<std::uint32_t>(triangles);
    }
    whole.table.draws.push_back(id);
    whole.orders.push_back(std::move(orders));
  }
  return whole;
}

}  // namespace foredraw
