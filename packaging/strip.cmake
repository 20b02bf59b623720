# SPDX-License-Identifier: MIT
# Takes from FILE what no Debian package carries: debug information, and notes of the compiler.
execute_process(COMMAND strip --strip-debug --remove-section=.comment --remove-section=.note
                        --enable-deterministic-archives "${FILE}" COMMAND_ERROR_IS_FATAL ANY)
