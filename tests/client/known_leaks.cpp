// OSMesa 22.3 keeps what OSMesaMakeCurrent allocated for its buffer, whatever its user does; the leak
// sanitizer asks this function what to overlook.

extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa";
}
