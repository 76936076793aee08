# cmake -DFOLDER=<io/viewer> -DSCRIPTS=<a.js,b.js> -DOUTPUT=<file.cpp> -P embed_page.cmake: puts the style
# and the scripts into viewer.html and writes the page as the bytes of a C++ array, which no limit on the
# length of literals touches.
cmake_minimum_required(VERSION 3.25)

file(READ ${FOLDER}/viewer.html page)
file(READ ${FOLDER}/viewer.css style)
string(REPLACE "," ";" SCRIPTS "${SCRIPTS}")
set(scripts "\"use strict\";\n")
foreach(name IN LISTS SCRIPTS)
  file(READ ${FOLDER}/${name} text)
  string(APPEND scripts "\n${text}")
endforeach()
string(REPLACE "{{style}}" "${style}" page "${page}")
string(REPLACE "{{scripts}}" "${scripts}" page "${page}")

string(HEX "${page}" bytes)
string(LENGTH "${bytes}" digits)
math(EXPR size "${digits} / 2")
string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE ${OUTPUT}
     "#include \"io/viewer_page.h\"

namespace tetsculpt {
namespace {

constexpr char kBytes[] = {
${bytes}
};

}  // namespace

const std::string_view kViewerPage(kBytes, ${size});

}  // namespace tetsculpt
")
