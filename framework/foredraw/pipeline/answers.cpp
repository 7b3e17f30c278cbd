#include <foredraw/pipeline/answers.h>

#include <foredraw/analysis/certificate.h>
#include <foredraw/viewing/pose_set.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

namespace {

template <class... Arguments>
void require(bool good, fmt::format_string<Arguments...> message, Arguments&&... arguments) {
  if (!good) throw std::runtime_error(fmt::format(message, std::forward<Arguments>(arguments)...));
}

/// An order that the table never names would only take memory; the first one stands alone and stays.
void leave_out_unnamed(SubjectOrders& answer) {
  std::vector<bool> is_named(answer.orders.front().size(), false);
  is_named[0] = true;
  for (const std::uint8_t order : answer.table.order) is_named[order] = true;
  OrderTable& table = answer.table;
  std::vector<std::uint16_t> sequences;
  for (std::size_t order = 0; order < is_named.size() && !table.parts.empty(); ++order) {
    if (is_named[order]) std::ranges::copy(table.sequence(order), std::back_inserter(sequences));
  }
  table.sequences = std::move(sequences);
  std::vector<std::uint8_t> number;
  std::uint8_t named = 0;
  for (const bool is : is_named) number.push_back(is ? named++ : named);
  for (std::uint8_t& order : table.order) order = number[order];
  for (std::vector<IndexOrder>& orders : answer.orders) {
    std::size_t kept = 0;
    for (std::size_t j = 0; j < orders.size(); ++j) {
      if (is_named[j]) std::swap(orders[kept++], orders[j]);
    }
    orders.resize(kept);
  }
}

void check_table_sequences(const SubjectView& subject, const OrderTable& table) {
  if (table.parts.empty()) return;
  require(table.parts == subject.subject.parts, "its table has sequences of other parts than the subject's");
  for (std::size_t first = 0; first < table.sequences.size(); first += table.parts.size()) {
    const auto sequence = table.sequence(first / table.parts.size());
    require(is_allowed(std::vector<std::uint32_t>(sequence.begin(), sequence.end()), subject.free_groups),
            "its table has a sequence that moves draws that must stay where they are");
  }
}

}  // namespace

void check_order(std::span<const std::uint32_t> order, std::size_t count, std::string_view what) {
  require(is_permutation(order, count), "its order of {} entries is not a permutation of {} {}", order.size(), count,
          what);
}

void check_clusters(const Clusters& clusters, std::size_t triangles) {
  require(is_partition(clusters, triangles), "its clusters are not a partition of {} triangles", triangles);
}

void check_sequence(const SubjectView& subject, std::span<const std::uint32_t> sequence) {
  check_order(sequence, subject.subject.parts.size(), "parts");
  require(is_allowed(sequence, subject.groups), "its sequence moves draws that must stay where they are");
}

void check_orders(const SubjectView& subject, const SubjectOrders& answer) {
  const OrderTable& table = answer.table;
  require(answer.orders.size() == table.draws.size(), "it orders {} draws, but its table names {}",
          answer.orders.size(), table.draws.size());
  if (!answer.sequence.empty()) check_sequence(subject, answer.sequence);
  if (!answer.sequence.empty() && answer.orders.empty()) return;
  require(!answer.orders.empty() && !answer.orders.front().empty(), "it returned no order");
  const std::size_t k = answer.orders.front().size();
  const std::optional<std::string> mistake = mistake_in(table, k);
  require(!mistake, "its table {}", mistake.value_or(""));
  check_table_sequences(subject, table);
  const std::vector<std::string> clips = clip_names(subject.scene);
  for (const OrderTable::Clip& clip : table.clips) {
    require(std::ranges::find(clips, clip.name) != clips.end(),
            "its table has clip '{}', which the scene does not have", clip.name);
  }

  for (std::size_t i = 0; i < table.draws.size(); ++i) {
    const DrawId id = table.draws[i];
    require(std::ranges::find(subject.draws, id) != subject.draws.end(), "it orders draw {}, which it was not given",
            id);
    require(answer.orders[i].size() == k, "it returned {} orders for one draw and {} for another", k,
            answer.orders[i].size());
    const std::size_t triangles = subject.scene.draws[id].full().stream().triangle_count();
    for (const IndexOrder& order : answer.orders[i]) check_order(order, triangles, "triangles");
  }
}

bool has_same_handles(const Draw& a, const Draw& b) {
  const auto same_stream = [](const IndexStream& x, const IndexStream& y) { return x.indices.is(y.indices); };
  const auto same_level = [&](const Level& x, const Level& y) {
    return x.vertices == y.vertices && std::ranges::equal(x.orders, y.orders, same_stream);
  };
  return a.topology == b.topology && a.material == b.material && std::ranges::equal(a.levels, b.levels, same_level);
}

void certify(const Draw& before, const Draw& after, Analyses& analyses) {
  require(before.levels.size() == after.levels.size(), "the certificate does not hold: levels were added or lost");
  for (std::size_t level = 0; level < before.levels.size(); ++level) {
    const Level& old = before.levels[level];
    const Certificate whole = certificate_of(*old.vertices, old.orders[0].indices.view(), analyses);
    for (const IndexStream& stream : after.levels[level].orders) {
      require(certificate_of(*after.levels[level].vertices, stream.indices.view(), analyses) == whole,
              "the certificate does not hold: it would draw other triangles than before");
    }
  }
}

Draw ordered(const DrawView& draw, const IndexOrder& order, int cache_size, Analyses& analyses) {
  check_order(order, draw.triangle_count(), "triangles");
  Draw result = with_triangle_order(draw.draw(), order);
  result.full().orders.resize(1);  // others went with the one that stood alone
  if (cache_size > 0) result.full().stream().cache_size = static_cast<std::uint16_t>(cache_size);
  certify(draw.draw(), result, analyses);
  return result;
}

Draw clustered(const DrawView& draw, Clusters clusters) {
  check_clusters(clusters, draw.triangle_count());
  Draw result = draw.draw();
  result.full().stream().clusters = std::move(clusters);
  return result;
}

OrderedSubject ordered(const SubjectView& subject, SubjectOrders answer, Analyses& analyses) {
  check_orders(subject, answer);
  OrderedSubject result;
  for (const std::uint32_t part : answer.sequence) result.sequence.push_back(subject.subject.parts[part]);
  if (answer.orders.empty()) return result;
  leave_out_unnamed(answer);
  const OrderTable& table = answer.table;
  for (std::size_t i = 0; i < table.draws.size(); ++i) {
    const Draw& before = subject.scene.draws[table.draws[i]];
    const IndexStream stream = before.full().stream();
    Draw draw = with_triangle_order(before, answer.orders[i][0]);
    draw.full().orders.resize(1);
    for (std::size_t j = 1; j < answer.orders[i].size(); ++j) {
      draw.full().orders.push_back(with_triangle_order(stream, answer.orders[i][j]));
    }
    certify(before, draw, analyses);
    result.draws.emplace_back(table.draws[i], std::move(draw));
  }
  result.table = std::move(answer.table);
  return result;
}

std::vector<std::pair<VertexGroup::User, Draw>> renumbered(const Scene& scene, const VertexGroup& group,
                                                           const VertexOrder& order, Analyses& analyses) {
  check_order(order, group.vertices->count, "vertices");
  std::vector<std::uint32_t> destination(order.size());
  for (std::uint32_t v = 0; v < order.size(); ++v) destination[order[v]] = v;
  std::vector<Draw> draws = with_vertices_moved(scene, group, destination, group.vertices->count);
  std::vector<std::pair<VertexGroup::User, Draw>> result;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    certify(scene.draws[group.users[i].draw], draws[i], analyses);
    result.emplace_back(group.users[i], std::move(draws[i]));
  }
  return result;
}

}  // namespace foredraw
