// OSMesa 22.3 keeps what OSMesaMakeCurrent allocated for its buffer, OpenXR's loader 1.0.20 keeps each
// instance that is destroyed, and fontconfig 2.14, by which cairo finds fonts, keeps its patterns, whatever
// their user does. The leak sanitizer asks this function what to overlook.

extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa\nleak:libopenxr_loader\nleak:libfontconfig";
}
