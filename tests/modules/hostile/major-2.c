/* Is for a version that is not yet. */
int foredraw_module_v2(void);
int foredraw_module_v2(void) { return 0; }
