# SPDX-License-Identifier: MIT
# cmake -DSOURCE=folder -DHEADER=file -P git_commit.cmake: writes the commit that the sources are of
# into a header, if it is not there already. Sources that differ from it, new ones too, add "-dirty-"
# and a hash of the differences, so that two versions of them do not pass for one.
set(sources agent assets benchmark sim CMakeLists.txt)
function(git output)
  execute_process(COMMAND git -C "${SOURCE}" ${ARGN}
    OUTPUT_VARIABLE text OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
  if(failed)
    set(text "")
  endif()
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

git(commit rev-parse --short=12 HEAD)
if(NOT commit)
  set(commit "unknown commit")
else()
  git(differences diff HEAD -- ${sources})
  execute_process(
    COMMAND git -C "${SOURCE}" ls-files --others --exclude-standard -- ${sources}
    COMMAND git -C "${SOURCE}" hash-object --stdin-paths
    OUTPUT_VARIABLE new ERROR_QUIET)
  if(differences OR new)
    string(SHA256 hash "${differences}${new}")
    string(SUBSTRING "${hash}" 0 8 hash)
    string(APPEND commit "-dirty-${hash}")
  endif()
endif()
set(text "#define BULLETNAV_COMMIT \"${commit}\"\n")
if(EXISTS "${HEADER}")
  file(READ "${HEADER}" before)
endif()
if(NOT text STREQUAL "${before}")
  file(WRITE "${HEADER}" "${text}")
endif()
