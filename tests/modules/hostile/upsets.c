/* Changes what the whole process has: folder, language, signals, rounding, and what becomes of small numbers. */
#include <fenv.h>
#include <locale.h>
#include "hostile.h"
static int run(RUN) {
  (void)!chdir("/");
  setlocale(LC_ALL, "de_DE.UTF-8");
  setenv("LC_ALL", "de_DE.UTF-8", 1);
  for (int number = 1; number < 32; ++number) signal(number, SIG_IGN);
  fesetround(FE_UPWARD);
#ifdef __x86_64__
  __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040u);
#endif
  return AS_IT_IS;
}
MODULE("upsets")
