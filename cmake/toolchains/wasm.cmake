# WebAssembly by Debian's Emscripten; what is built runs in Node.
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
