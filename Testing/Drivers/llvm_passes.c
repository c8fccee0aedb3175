/* Shows what Mesa's lavapipe asks of LLVM's optimizer, keeps the modules, and lets other passes or options of LLVM be
 * tried. Preloaded into a program; README.md has an example.
 *
 * LLVM_LIBRARY  the driver's library of LLVM (ldd libvulkan_lvp.so), default libLLVM.so.21.1
 * LLVM_DUMP     folder for the bitcode before each call, 0.bc, 1.bc, ...
 * LLVM_PASSES   passes in place of the driver's, but for those of -O0, which it needs for coroutines
 * LLVM_OPTIONS  options with spaces between them, such as -regalloc=basic -verify-machineinstrs
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
  const char *dump = getenv("LLVM_DUMP"), *wanted = getenv("LLVM_OPTIONS"), *other = getenv("LLVM_PASSES");
  if (wanted && call == 0)
  {
    void (*parse)(int, const char**, const char*) = Symbol("LLVMParseCommandLineOptions");
    const char* arguments[64] = { "driver" };
    int count = 1;
    char *words = strdup(wanted), *rest;
    for (char* word = strtok_r(words, " ", &rest); word && count < 64; word = strtok_r(0, " ", &rest))
    {
      arguments[count++] = word;
    }
    parse(count, arguments, "");
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
