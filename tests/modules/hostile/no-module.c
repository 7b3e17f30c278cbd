/* Is a library, and no module. */
int moon(void);
int moon(void) { return 0; }
