#pragma once
// The settings of how a scene is written: one table of names, values and help. The parser of [output], --set, the
// schema, the command line's options and the settings of the C library and of Python follow it.

#include <foredraw/base/diagnostics.h>
#include <foredraw/scene/output_settings.h>
#include <foredraw/technique/options.h>

#include <string>
#include <string_view>

namespace foredraw {

OptionTable<OutputSettings> output_words();

/// The words of the settings that differ from their defaults.
Settings words_of(const OutputSettings& output);

/// Sets one; false, with an error at `where`, if there is no such setting or it cannot have that value.
bool set_output(OutputSettings& output, const std::string& word, const OptionValue& value, const Where& where,
                Diagnostics& diagnostics);

/// Sets those of a line, "compression=none, levels=msft-lod"; `name` is what diagnostics call it.
bool set_output(OutputSettings& output, std::string_view line, const std::string& name, Diagnostics& diagnostics);

}  // namespace foredraw
