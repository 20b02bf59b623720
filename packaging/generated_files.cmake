# SPDX-License-Identifier: MIT
# Writes the files that the program generates below ROOT/PREFIX: a manual page for each command, and completion scripts
# for three shells.
set(place "${ROOT}${PREFIX}")
function(says file)
    execute_process(COMMAND "${PROGRAM}" ${ARGN} OUTPUT_FILE "${file}" RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "${PROGRAM} ${ARGN} failed; see the error above")
    endif()
endfunction()

execute_process(COMMAND "${PROGRAM}" help OUTPUT_VARIABLE overview)
string(REGEX REPLACE "^.*\nCommands:(\n.*)\n\n`.*$" "\\1" overview "${overview}")
string(REGEX MATCHALL "\n  [a-z0-9]+" verbs "${overview}")
list(TRANSFORM verbs STRIP)
file(MAKE_DIRECTORY "${place}/share/man/man1")
says("${place}/share/man/man1/grafverif.1" manual)
foreach(verb IN LISTS verbs)
    says("${place}/share/man/man1/grafverif-${verb}.1" manual ${verb})
endforeach()
file(GLOB pages "${place}/share/man/man1/grafverif*.1")
execute_process(COMMAND gzip -9 -n -f ${pages})

set(zsh site-functions)  # for zsh built from source; Debian's zsh reads another folder for packages
if(PREFIX STREQUAL "/usr")
    set(zsh vendor-completions)
endif()
foreach(shell_and_file "bash:bash-completion/completions/grafverif" "zsh:zsh/${zsh}/_grafverif"
                       "fish:fish/vendor_completions.d/grafverif.fish")
    string(REGEX MATCH "^([a-z]+):(.*)$" _ "${shell_and_file}")
    get_filename_component(folder "${place}/share/${CMAKE_MATCH_2}" DIRECTORY)
    file(MAKE_DIRECTORY "${folder}")
    says("${place}/share/${CMAKE_MATCH_2}" completion ${CMAKE_MATCH_1})
endforeach()
