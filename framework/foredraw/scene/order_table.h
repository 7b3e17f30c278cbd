#pragma once
// Which of the k orders to draw: the table that a subject orderer answers with and an engine looks up each frame.

#include <foredraw/scene/subject.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

/// For every (clip, keyframe, theta, phi) the number of an order, the same number for all draws of the subject; a draw
/// is in one table at most. theta is the angle from +Y in [0, pi], phi = atan2(z, x) in [-pi, pi), both in equal steps:
/// runtime/order_table.h is the one definition of where cells and keyframes end.
struct OrderTable {
  struct Clip {
    std::string name;          ///< as clip_names() of the scene tells it
    std::vector<float> times;  ///< of the keyframes, seconds, rising
    friend bool operator==(const Clip&, const Clip&) = default;
  };
  std::vector<DrawId> draws;
  std::vector<Clip> clips;  ///< none: the pose does not matter
  std::uint32_t theta_steps = 1;
  std::uint32_t phi_steps = 1;
  std::vector<std::uint8_t> order;  ///< [keyframe of all clips in turn][theta][phi]
  /// The parts of the subject, and in which sequence they are drawn with each order: [order][rank] = number in `parts`.
  /// No file holds them, so any part may come anywhere. None: parts are drawn as the file's walk has them.
  std::vector<SubjectPart> parts = {};
  std::vector<std::uint16_t> sequences = {};

  std::size_t keyframes() const {
    std::size_t n = 0;
    for (const Clip& clip : clips) n += clip.times.size();
    return n == 0 ? 1 : n;
  }
  std::size_t cells() const { return keyframes() * theta_steps * phi_steps; }
  std::span<const std::uint16_t> sequence(std::size_t order) const {
    return std::span(sequences).subspan(order * parts.size(), parts.size());
  }

  friend bool operator==(const OrderTable&, const OrderTable&) = default;
};

/// The product of orderers that answer with several orders for a draw.
struct DrawOrders {
  static constexpr std::string_view product = "draw-orders";
  std::vector<OrderTable> tables;
  friend bool operator==(const DrawOrders&, const DrawOrders&) = default;
};

/// Of the scene; empty where no draw has several orders.
std::span<const OrderTable> order_tables(const Scene& scene);

/// What is wrong with a table that chooses among `orders`, as the rest of a sentence that begins with it: what it names
/// twice, times that do not rise, more steps than 2^16, too many or too few cells, an order beyond those there are,
/// sequences of which there is not one for each order, or that are no permutation of the parts. Whether its draws,
/// clips and parts exist is the scene's to say.
std::optional<std::string> mistake_in(const OrderTable& table, std::size_t orders);

}  // namespace foredraw
