# SPDX-License-Identifier: MIT
# Sets RESULT to TEXT as a C++ string literal. A text of more than 65,535 characters, the limit of raw strings, is split
# into several adjacent literals.
function(literal_of text result)
    set(literal "")
    string(LENGTH "${text}" length)
    foreach(at RANGE 0 ${length} 8000)
        string(SUBSTRING "${text}" ${at} 8000 piece)
        string(APPEND literal "\nR\"~~~(${piece})~~~\"")
    endforeach()
    set(${result} "${literal}" PARENT_SCOPE)
endfunction()
