/* Shows what Mesa's lavapipe asks of LLVM's optimizer, keeps the modules, and lets other passes or options of LLVM be
 * tried. Preloaded into a program; README.md has an example.
 *
 * LLVM_LIBRARY  the driver's library of LLVM (ldd libvulkan_lvp.so), default libLLVM.so.21.1
 * LLVM_DUMP     folder for the bitcode before each call, 0.bc, 1.bc, ...
 * LLVM_PASSES   passes in place of the driver's, but for those of -O0, which it needs for coroutines
 * LLVM_OPTION   one option, such as -instcombine-code-sinking=0
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void* Symbol(const char* name)
{
  const char* library = getenv("LLVM_LIBRARY");
  return dlsym(dlopen(library ? library : "libLLVM.so.21.1", RTLD_LAZY | RTLD_NOLOAD), name);
}

void* LLVMRunPasses(void* module, const char* passes, void* machine, void* options)
{
  void* (*run)(void*, const char*, void*, void*) = Symbol("LLVMRunPasses");
  static atomic_int calls;
  const int call = atomic_fetch_add(&calls, 1);
  const char *dump = getenv("LLVM_DUMP"), *option = getenv("LLVM_OPTION"), *other = getenv("LLVM_PASSES");
  if (option && call == 0)
  {
    void (*parse)(int, const char**, const char*) = Symbol("LLVMParseCommandLineOptions");
    const char* arguments[] = { "driver", option };
    parse(2, arguments, "");
  }
  if (dump)
  {
    int (*write)(void*, const char*) = Symbol("LLVMWriteBitcodeToFile");
    char path[4096];
    snprintf(path, sizeof(path), "%s/%d.bc", dump, call);
    write(module, path);
  }
  const char* used = other && !strstr(passes, "O0") ? other : passes;
  fprintf(stderr, "call %d: %s\n", call, used);
  return run(module, used, machine, options);
}
