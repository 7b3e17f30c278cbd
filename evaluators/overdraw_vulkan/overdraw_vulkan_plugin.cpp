#include "overdraw_vulkan.h"

#include <foredraw/measuring/overdraw_evaluator.h>

#include <fmt/format.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace foredraw {

namespace {

struct OverdrawVulkanOptions : OverdrawOptions {
  std::optional<std::string> device;
  bool times = false;
};

class OverdrawVulkanService final : public OverdrawService {
 public:
  explicit OverdrawVulkanService(const OverdrawVulkanOptions& options)
      : OverdrawService(options.faces), options_(options) {}

  OverdrawCounts draw(std::span<const RasterPart> parts, const Views& views, Run&) const override {
    const std::lock_guard lock(one_at_a_time_);
    return overdraw_vulkan(device(), parts, views);
  }

  /// Of the subjects at rest.
  void tell_more(const Scene& scene, std::span<const Subject> subjects, const Views& views, Run& run) const override {
    const std::lock_guard lock(one_at_a_time_);
    run.note("device", fmt::format("drawn by {}, with a {}-bit depth buffer", device().name(), device().depth_bits()));
    const bool takes_times = options_.times && !device().is_processor();
    if (options_.times && device().is_processor()) {
      run.note("no-times", fmt::format("no times were taken: {} runs on the processor", device().name()));
    }
    std::vector<std::uint64_t> invocations(scene.draws.size());
    std::vector<std::size_t> triangles(scene.draws.size());
    GpuTime time;
    const PosedNodes at_rest = posed_nodes(scene);
    for (std::size_t s = 0; s < subjects.size(); ++s) {
      if (run.cancelled()) return;
      const SubjectGeometry drawn = subject_geometry(scene, subjects[s], faces(), at_rest, run.analyses);
      const std::span<const RasterPart> parts = drawn.parts;
      if (const auto of_parts = vertex_shader_invocations(device(), parts)) {
        for (std::size_t i = 0; i < of_parts->size(); ++i) {
          const DrawId draw = subjects[s].parts[i].draw;
          invocations[draw] += (*of_parts)[i];
          triangles[draw] += parts[i].indices.size() / 3;
        }
      }
      if (!takes_times) continue;
      if (const auto of_subject = gpu_time(device(), parts, views)) {
        time.light += of_subject->light;
        time.heavy += of_subject->heavy;
      }
    }
    for (DrawId draw = 0; draw < triangles.size(); ++draw) {
      if (invocations[draw] == 0) continue;
      run.measure_at({draw, {}, {}}, "vertex-shader-invocations", static_cast<double>(invocations[draw]),
                     static_cast<double>(triangles[draw]));
    }
    if (time.light > 0) {
      run.measure("gpu-time-light", time.light, static_cast<double>(views.views.size()));
      run.measure("gpu-time-heavy", time.heavy, static_cast<double>(views.views.size()));
    }
  }

 private:
  /// Made when it is first drawn with: who lists plugins or plans a run starts no driver.
  OverdrawDevice& device() const {
    if (!device_) device_ = std::make_unique<OverdrawDevice>(gpu::DeviceChoice{options_.device.value_or("")});
    return *device_;
  }

  OverdrawVulkanOptions options_;
  mutable std::mutex one_at_a_time_;
  mutable std::unique_ptr<OverdrawDevice> device_;
};

void add_rows(OptionTable<OverdrawVulkanOptions>& table) {
  table.row(
      &OverdrawVulkanOptions::device, "device",
      "Part of the name of the device to draw with; by default a hardware device, else one that runs on the processor");
  table.row(&OverdrawVulkanOptions::times, "times",
            "Measure times too; they differ from run to run, as no other figure does");
}

}  // namespace

Plugin overdraw_vulkan_plugin() {
  Plugin plugin = overdraw_plugin<OverdrawVulkanOptions>(
      {
          .name = "overdraw-vulkan",
          .summary = "Measures overdraw and vertex shading by drawing every subject from many sides on a Vulkan device",
          .reference = "Han, Sander 2016, section 1 (overdraw ratio); own",
          .metrics =
              {
                  {"vertex-shader-invocations", "invocations per triangle",
                   "How often the device runs the vertex shader, with its real vertex cache"},
                  {"gpu-time-light", "ms per view",
                   "Time on the device with a fragment shader that costs next to nothing"},
                  {"gpu-time-heavy", "ms per view",
                   "Time on the device with an expensive fragment shader: 256 sines in a row"},
              },
      },
      add_rows, [](const OverdrawVulkanOptions& options) { return std::make_unique<OverdrawVulkanService>(options); });
  plugin.unavailable = [] { return gpu::why_no_device(); };
  plugin.device = [](const Settings& settings) {
    const auto device = settings.find("device");
    const auto* name = device == settings.end() ? nullptr : std::get_if<std::string>(&device->second);
    return gpu::device_text({name == nullptr ? "" : *name});
  };
  return plugin;
}

}  // namespace foredraw
