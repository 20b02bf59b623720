# SPDX-License-Identifier: MIT
# Removes debug information and notes of the compiler from FILE, as required for Debian packages.
execute_process(COMMAND strip --strip-debug --remove-section=.comment --remove-section=.note
                        --enable-deterministic-archives "${FILE}" COMMAND_ERROR_IS_FATAL ANY)
