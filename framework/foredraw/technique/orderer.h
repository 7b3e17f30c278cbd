#pragma once
// Orderers answer with an order; the framework checks it, applies it and certifies what came out. Three shapes of one
// kind: of a draw's triangles, of the draws of a subject together, of the vertices that draws share. An orderer that
// finds that nothing can be gained says so by run.keep(reason) and may answer with anything.

#include <foredraw/scene/order_table.h>
#include <foredraw/scene/part_groups.h>
#include <foredraw/scene/reorder.h>
#include <foredraw/scene/subject.h>
#include <foredraw/technique/draw_view.h>
#include <foredraw/technique/run.h>

namespace foredraw {

/// Orders the triangles of one draw. Called for many draws at once.
class DrawOrderer {
 public:
  static constexpr std::string_view works_on = "draws";  ///< what the framework loops over
  virtual ~DrawOrderer() = default;
  virtual IndexOrder order(const DrawView&, Run&) const = 0;
  /// The vertex cache that the order is made for, in entries; 0: the draw's own stays. Kept with the index stream.
  virtual int cache_size() const { return 0; }
};

struct SubjectView {
  const Scene& scene;
  const Subject& subject;
  std::vector<DrawId> draws;  ///< those of the subject's draws that may be ordered anew
  /// Which of the subject's parts may change places; none where something in the scene may refer to them by number.
  std::vector<PartGroup> groups = {};
  /// Which of them may change places in a table's sequences, which no file has to hold; none where nothing may.
  std::vector<PartGroup> free_groups = {};
};

/// k orders for each draw of a subject, and the table that says which to draw when; a sequence of its parts; or both.
struct SubjectOrders {
  /// [i][j]: order j of draw table.draws[i], which is one of the view's draws. orders[i][0] stands alone.
  std::vector<std::vector<IndexOrder>> orders;
  /// Its sequences are of all the subject's parts, and move them as the view's
  /// free groups allow it.
  OrderTable table;
  /// [rank] = part of the subject, as the view's groups allow it. Empty: the parts stay where they are. Coarser levels
  /// are drawn in the sequence of full detail, so only full detail may be answered with one.
  std::vector<std::uint32_t> sequence = {};
};

/// Orders the draws of one subject together.
class SubjectOrderer {
 public:
  static constexpr std::string_view works_on = "subjects";
  virtual ~SubjectOrderer() = default;
  virtual SubjectOrders order(const SubjectView&, Run&) const = 0;
};

/// Vertices and every index stream that uses them, in draw order.
struct VertexUse {
  const VertexStreams& vertices;
  std::vector<std::span<const std::uint32_t>> index_streams;
};

/// Numbers the vertices of one VertexStreams anew; the framework moves all attributes, targets and indices.
class VertexOrderer {
 public:
  static constexpr std::string_view works_on = "vertex streams";
  virtual ~VertexOrderer() = default;
  virtual VertexOrder order(const VertexUse&, Run&) const = 0;
};

}  // namespace foredraw
