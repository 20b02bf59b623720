# SPDX-License-Identifier: MIT
# Writes OUTPUT, a C++ source with two texts: the files STYLES joined to one style, and the modules SCRIPTS joined to
# one script. Each text has its SHA-256 in base64, because a page permits only scripts and styles with these hashes. To
# join the modules, `import` lines and `export` keywords are removed; therefore the names in all modules must be distinct.
include("${CMAKE_CURRENT_LIST_DIR}/literal.cmake")

function(base64_of hex result)
    set(letters "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/")
    string(APPEND hex "00")  # a 33rd byte, because base64 encodes groups of three bytes; its letter becomes padding
    set(text "")
    foreach(at RANGE 0 65 6)
        string(SUBSTRING "${hex}" ${at} 6 three)
        foreach(shift 18 12 6 0)
            math(EXPR place "(0x${three} >> ${shift}) & 63")
            string(SUBSTRING "${letters}" ${place} 1 letter)
            string(APPEND text "${letter}")
        endforeach()
    endforeach()
    string(SUBSTRING "${text}" 0 43 text)
    set(${result} "${text}=" PARENT_SCOPE)
endfunction()

set(style "")
foreach(file IN LISTS STYLES)
    file(READ "${file}" part)
    string(APPEND style "${part}")
endforeach()
set(script "")
set(modules "")  # one literal per module, because one literal for all modules may exceed the limit of compilers
foreach(file IN LISTS SCRIPTS)
    file(READ "${file}" module)
    string(REGEX REPLACE "\nimport [^\n]*" "" module "${module}")
    string(REGEX REPLACE "\nexport " "\n" module "${module}")
    string(APPEND script "${module}")
    literal_of("${module}" literal)
    string(APPEND modules "        ${literal},\n")
endforeach()
foreach(each style script)
    string(SHA256 hash "${${each}}")
    base64_of("${hash}" ${each}_hash)
endforeach()
literal_of("${style}" style_literal)
file(WRITE "${OUTPUT}" "// SPDX-License-Identifier: MIT
#include \"page/web.hpp\"

#include <string>

namespace grafverif {

WebText page_style() { return {${style_literal}, \"${style_hash}\"}; }

WebText page_script() {
    static const std::string text = [] {
        std::string all;
        for (const char* const module : {
${modules}             })
            all += module;
        return all;
    }();
    return {text, \"${script_hash}\"};
}

}  // namespace grafverif
")
