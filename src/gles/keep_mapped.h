// Libraries that must not be unloaded.
#pragma once

namespace metamer {

/// Pins every shared library that is loaded now until the process ends. EGL unloads the driver on its way
/// out, and LeakSanitizer, which looks afterwards, then takes what the driver's statics still hold for lost.
void keep_libraries_mapped();

} // namespace metamer
