#include <foredraw/viewing/drawn_orders.h>

#include <foredraw/viewing/order_lookup.h>
#include <foredraw/viewing/pose_set.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

namespace foredraw {

namespace {

/// A table that draws some of a subject's parts, in one pose.
struct PosedTable {
  OrderLookup lookup;
  std::span<const std::uint8_t> cells;  ///< none: order 0
  std::vector<std::size_t> parts;
  /// [order][rank] = part of the subject, of those that the table's sequences name.
  std::vector<std::vector<std::uint32_t>> sequences;
};

/// What a table calls its parts, as the subject numbers them.
class NumberedParts {
 public:
  NumberedParts(const Subject& subject, const OrderTable& table) {
    std::map<std::pair<DrawId, std::optional<NodeId>>, std::uint32_t> known;
    for (std::uint32_t part = 0; part < subject.parts.size(); ++part) {
      known.emplace(std::pair(subject.parts[part].draw, subject.parts[part].node), part);
    }
    for (const auto& [draw, node] : table.parts) {
      const auto part = known.find({draw, node});
      numbers_.push_back(part == known.end() ? std::nullopt : std::optional(part->second));
    }
  }

  /// Those of the sequence that the subject has.
  std::vector<std::uint32_t> of(std::span<const std::uint16_t> sequence) const {
    std::vector<std::uint32_t> parts;
    for (const std::uint16_t number : sequence) {
      if (numbers_[number]) parts.push_back(*numbers_[number]);
    }
    return parts;
  }

 private:
  std::vector<std::optional<std::uint32_t>> numbers_;
};

std::vector<std::vector<std::uint32_t>> sequences_of(const OrderTable& table, const Subject& subject) {
  const NumberedParts numbered(subject, table);
  std::vector<std::vector<std::uint32_t>> sequences;
  for (std::size_t first = 0; first < table.sequences.size(); first += table.parts.size()) {
    sequences.push_back(numbered.of(table.sequence(first / table.parts.size())));
  }
  return sequences;
}

std::vector<PosedTable> tables_of(const Scene& scene, const Subject& subject, const Pose& pose) {
  std::vector<PosedTable> tables;
  if (order_tables(scene).empty()) return tables;
  const std::vector<std::string> names = clip_names(scene);
  for (const OrderTable& table : order_tables(scene)) {
    std::vector<std::size_t> parts;
    for (std::size_t i = 0; i < subject.parts.size(); ++i) {
      if (std::ranges::find(table.draws, subject.parts[i].draw) != table.draws.end()) parts.push_back(i);
    }
    if (parts.empty()) continue;
    tables.push_back({OrderLookup(table, names), {}, std::move(parts), sequences_of(table, subject)});
    tables.back().cells = tables.back().lookup.cells_in(pose);
  }
  return tables;
}

std::vector<std::uint32_t> as_in_file(const Subject& subject) {
  std::vector<std::uint32_t> sequence(subject.parts.size());
  std::iota(sequence.begin(), sequence.end(), 0u);
  return sequence;
}

std::vector<std::uint32_t> by_material(const Scene& scene, const Subject& subject) {
  std::vector<std::uint32_t> sequence = as_in_file(subject);
  std::ranges::stable_sort(sequence, {},
                           [&](std::uint32_t part) { return scene.draws[subject.parts[part].draw].material; });
  return sequence;
}

/// The places that these parts have are theirs, in this sequence. Of a sequence that is as in the file where they are.
void put(std::span<const std::uint32_t> parts, std::vector<std::uint32_t>& sequence) {
  std::vector<std::uint32_t> places(parts.begin(), parts.end());
  std::ranges::sort(places);
  for (std::size_t i = 0; i < parts.size(); ++i) sequence[places[i]] = parts[i];
}

}  // namespace

std::vector<ViewsOfOrders> views_by_orders(const Scene& scene, const Subject& subject, const Pose& pose,
                                           std::span<const View> views, SequenceFrom said_by) {
  const std::vector<PosedTable> tables = tables_of(scene, subject, pose);
  const std::vector<std::uint32_t> sequence =
      said_by == SequenceFrom::material ? by_material(scene, subject) : as_in_file(subject);
  ViewsOfOrders one{std::vector<std::uint32_t>(subject.parts.size(), 0), sequence, {}};
  if (tables.empty()) {
    one.views.resize(views.size());
    std::iota(one.views.begin(), one.views.end(), std::size_t{0});
    return {std::move(one)};
  }
  using Drawn = std::pair<std::vector<std::uint32_t>, std::vector<std::uint32_t>>;  // orders, sequence
  std::map<Drawn, std::vector<std::size_t>> alike;
  for (std::size_t view = 0; view < views.size(); ++view) {
    one.sequence = sequence;
    for (const PosedTable& table : tables) {
      const std::uint32_t order = table.cells.empty() ? 0 : table.cells[table.lookup.cell_of(views[view].direction)];
      for (const std::size_t part : table.parts) one.orders[part] = order;
      if (said_by == SequenceFrom::table && order < table.sequences.size()) put(table.sequences[order], one.sequence);
    }
    alike[{one.orders, one.sequence}].push_back(view);
  }
  std::vector<ViewsOfOrders> result;
  for (auto& [drawn, numbers] : alike) result.push_back({drawn.first, drawn.second, std::move(numbers)});
  return result;
}

std::vector<std::uint32_t> parts_in_sequence(const Subject& subject, const OrderTable& table,
                                             std::span<const std::uint16_t> sequence) {
  std::vector<std::uint32_t> all = as_in_file(subject);
  put(NumberedParts(subject, table).of(sequence), all);
  return all;
}

Views chosen(const Views& views, std::span<const std::size_t> numbers) {
  Views some{{}, views.size};
  for (const std::size_t number : numbers) some.views.push_back(views.views[number]);
  return some;
}

std::vector<RasterPart> parts_as_drawn(const SubjectGeometry& posed, const Scene& scene, const Subject& subject,
                                       const ViewsOfOrders& as) {
  std::vector<RasterPart> drawn;
  for (const std::uint32_t part : as.sequence) {
    drawn.push_back(posed.parts[part]);
    if (drawn.back().indices.empty()) continue;  // not drawn
    drawn.back().indices = scene.draws[subject.parts[part].draw].full().orders.at(as.orders[part]).indices.view();
  }
  return drawn;
}

Stamp orders_stamp(const Scene& scene, const Subject& subject, const Pose& pose) {
  std::vector<Stamp> stamps;
  for (const PosedTable& table : tables_of(scene, subject, pose)) stamps.push_back(content_hash(table.cells));
  return combine(stamps);
}

}  // namespace foredraw
