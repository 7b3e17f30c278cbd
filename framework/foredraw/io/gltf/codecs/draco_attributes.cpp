// Decoders of Draco's attributes, derived from libdraco's own, that loop no longer than there are corners.
#include <foredraw/io/gltf/codecs/private/draco_attributes.h>

#include <draco/compression/attributes/sequential_attribute_decoders_controller.h>
#include <draco/compression/attributes/sequential_quantization_attribute_decoder.h>
#include <draco/compression/mesh/mesh_decoder.h>

#include <stdexcept>
#include <utility>

namespace foredraw::gltf {

namespace {

/// A buffer whose texture coordinates are predicted tells how many turns follow, and libdraco reads so many bits from
/// however few bytes. There can be one for each corner at most.
class BoundedPrediction final : public draco::PredictionSchemeTypedDecoderInterface<std::int32_t> {
 public:
  BoundedPrediction(std::unique_ptr<PredictionSchemeTypedDecoderInterface> scheme, std::uint64_t corners)
      : scheme_(std::move(scheme)), corners_(corners) {}

  bool DecodePredictionData(draco::DecoderBuffer* buffer) override {
    std::int32_t turns = 0;
    if (!buffer->Peek(&turns) || turns < 0 || static_cast<std::uint64_t>(turns) > corners_) return false;
    return scheme_->DecodePredictionData(buffer);
  }

  bool ComputeOriginalValues(const std::int32_t* corrections, std::int32_t* values, int size, int components,
                             const draco::PointIndex* points) override {
    return scheme_->ComputeOriginalValues(corrections, values, size, components, points);
  }
  draco::PredictionSchemeMethod GetPredictionMethod() const override { return scheme_->GetPredictionMethod(); }
  const draco::PointAttribute* GetAttribute() const override { return scheme_->GetAttribute(); }
  bool IsInitialized() const override { return scheme_->IsInitialized(); }
  int GetNumParentAttributes() const override { return scheme_->GetNumParentAttributes(); }
  draco::GeometryAttribute::Type GetParentAttributeType(int i) const override {
    return scheme_->GetParentAttributeType(i);
  }
  bool SetParentAttribute(const draco::PointAttribute* parent) override { return scheme_->SetParentAttribute(parent); }
  bool AreCorrectionsPositive() override { return scheme_->AreCorrectionsPositive(); }
  draco::PredictionSchemeTransformType GetTransformType() const override { return scheme_->GetTransformType(); }

 private:
  std::unique_ptr<PredictionSchemeTypedDecoderInterface> scheme_;
  std::uint64_t corners_;
};

/// A decoder of one attribute's integers.
template <class Decoder>
class BoundedIntegers final : public Decoder {
  std::unique_ptr<draco::PredictionSchemeTypedDecoderInterface<std::int32_t>> CreateIntPredictionScheme(
      draco::PredictionSchemeMethod method, draco::PredictionSchemeTransformType transform) override {
    // The older prediction of texture coordinates is none of bitstream 2.2, and has the same fault.
    if (method == draco::MESH_PREDICTION_TEX_COORDS_DEPRECATED)
      throw std::runtime_error("texture coordinates are predicted as bitstream 2.2 does not");
    auto scheme = Decoder::CreateIntPredictionScheme(method, transform);
    if (!scheme || method != draco::MESH_PREDICTION_TEX_COORDS_PORTABLE) return scheme;
    const std::uint64_t faces = static_cast<draco::MeshDecoder*>(this->decoder())->mesh()->num_faces();
    return std::make_unique<BoundedPrediction>(std::move(scheme), 3 * faces);
  }
};

using Sequencer = std::unique_ptr<draco::PointsSequencer>;

/// `rounded` gets the attributes whose floats the encoder rounded.
class BoundedAttributes final : public draco::SequentialAttributeDecodersController {
 public:
  BoundedAttributes(Sequencer sequencer, std::set<std::int32_t>& rounded)
      : SequentialAttributeDecodersController(std::move(sequencer)), rounded_(rounded) {}

 protected:
  std::unique_ptr<draco::SequentialAttributeDecoder> CreateSequentialDecoder(std::uint8_t type) override {
    const std::int32_t attribute = GetAttributeId(made_++);  // libdraco asks for one after the other
    if (type == draco::SEQUENTIAL_ATTRIBUTE_ENCODER_QUANTIZATION || type == draco::SEQUENTIAL_ATTRIBUTE_ENCODER_NORMALS)
      rounded_.insert(attribute);
    switch (type) {
      case draco::SEQUENTIAL_ATTRIBUTE_ENCODER_INTEGER:
        return std::make_unique<BoundedIntegers<draco::SequentialIntegerAttributeDecoder>>();
      case draco::SEQUENTIAL_ATTRIBUTE_ENCODER_QUANTIZATION:
        return std::make_unique<BoundedIntegers<draco::SequentialQuantizationAttributeDecoder>>();
      default: return SequentialAttributeDecodersController::CreateSequentialDecoder(type);
    }
  }

 private:
  std::set<std::int32_t>& rounded_;
  std::int32_t made_ = 0;
};

Sequencer& sequencer_of(draco::SequentialAttributeDecodersController& controller);

/// Only a controller knows the sequence that was made for it, and a derived one needs the same. Access is not checked
/// in an explicit instantiation.
template <Sequencer draco::SequentialAttributeDecodersController::*member>
struct Opened {
  friend Sequencer& sequencer_of(draco::SequentialAttributeDecodersController& controller) {
    return controller.*member;
  }
};
template struct Opened<&draco::SequentialAttributeDecodersController::sequencer_>;

}  // namespace

std::unique_ptr<draco::AttributesDecoderInterface> bounded_attributes(draco::AttributesDecoderInterface& made,
                                                                      std::set<std::int32_t>& rounded) {
  auto& controller = static_cast<draco::SequentialAttributeDecodersController&>(made);
  return std::make_unique<BoundedAttributes>(std::move(sequencer_of(controller)), rounded);
}

}  // namespace foredraw::gltf
