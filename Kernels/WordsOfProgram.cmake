# Writes the words of a SPIR-V module as a C++ array. Usage: cmake -D module=FILE -D name=NAME -D output=FILE -P WordsOfProgram.cmake
file(READ "${module}" bytes HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1,\n" words "${bytes}")
file(WRITE "${output}" "const std::uint32_t ${name}[] = {\n${words}};\n")
