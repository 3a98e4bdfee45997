# One file per solver kind, beside the tool: the compiler, its options and the sources that determine the kind's answer,
# which are part of the key of each of its results (runs/run_key.hpp). The code of another solver, of metrics, gates,
# reports and campaigns is none of it, so that a change there leaves the results as they are; nor are comments and
# layout. The files are written whenever the tool is linked, so that they are those of its code.
#
#   solver_sources(KIND LIBRARY NAMES...)   KIND rests on the sources of each library whose names, without .cpp, match
set(requests ${CMAKE_BINARY_DIR}/verification/slosh.requests)
set(builds ${CMAKE_BINARY_DIR}/verification/slosh.builds)
file(MAKE_DIRECTORY ${builds})

# What a case asks for enters the keys by its values; the runners are declared together.
set(left_out verification/case/case_definition.hpp verification/solvers/solver_runs.hpp)
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
get_target_property(flags slosh_flags INTERFACE_COMPILE_OPTIONS)
get_target_property(definitions slosh_flags INTERFACE_COMPILE_DEFINITIONS)
set(compilation "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} ${CMAKE_SYSTEM_PROCESSOR}, Eigen ${Eigen3_VERSION}, Boost ${Boost_VERSION}
C++ ${CMAKE_CXX_STANDARD} ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} ${flags} ${definitions}\n")

function(solver_sources kind)
  set(request "${compilation}")
  foreach(name ${left_out})
    string(APPEND request "leave out ${name}\n")
  endforeach()
  while(ARGN)
    list(POP_FRONT ARGN library names)
    get_target_property(sources ${library} SOURCES)
    get_target_property(directory ${library} SOURCE_DIR)
    get_target_property(options ${library} COMPILE_OPTIONS)
    get_target_property(definitions ${library} COMPILE_DEFINITIONS)
    cmake_path(RELATIVE_PATH directory BASE_DIRECTORY ${CMAKE_SOURCE_DIR})
    list(FILTER sources INCLUDE REGEX "^(${names})[.]cpp$")
    if(NOT sources)
      message(FATAL_ERROR "solver_sources(${kind}): ${library} has no source ${names}")
    endif()
    string(APPEND request "${library} ${options} ${definitions}\n")
    foreach(source ${sources})
      string(APPEND request "source ${directory}/${source}\n")
    endforeach()
  endwhile()
  file(GENERATE OUTPUT ${requests}/${kind} CONTENT "${request}" TARGET slosh_tool)
  set_property(TARGET slosh_tool APPEND PROPERTY LINK_DEPENDS ${requests}/${kind})
  add_custom_command(TARGET slosh_tool POST_BUILD VERBATIM
    COMMAND write_solver_sources ${builds}/${kind} ${requests}/${kind} ${CMAKE_SOURCE_DIR})
endfunction()

set(runs ${CMAKE_CURRENT_LIST_DIR}/runs)
add_executable(write_solver_sources ${runs}/solver_sources.cpp ${runs}/write_solver_sources.cpp)
target_link_libraries(write_solver_sources PRIVATE slosh_flags)
target_compile_options(write_solver_sources PRIVATE ${quick_build})
add_dependencies(slosh_tool write_solver_sources)

set(motion "motion|cubic_spline|field_times")
set(motion_times "${motion}|motion/motion_times")
set(theory slosh_reference ".*" slosh_results result_file slosh_case)
set(importing slosh_import ".*" slosh_results result_file
              slosh_input "units|tables/series_files|tables/table_head|tables/table_reader|tables/table_rows")

solver_sources(sph slosh_sph ".*" slosh_solvers "sph_run|sph_scene|snapshots|particles/state_file"
               slosh_case ${motion} slosh_results result_file)
solver_sources(interfoam slosh_openfoam ".*" slosh_dictionary_digest ".*" slosh_peers interfoam_tank
               slosh_solvers interfoam_run slosh_case ${motion_times} slosh_results result_file)
solver_sources(linear ${theory} "${motion_times}|shape/sensor_place|shape/outline" slosh_solvers
               "linear_run|theory/linear_flow_in_rectangle|theory/linear_flow_in_outline|theory/beyond_linear")
solver_sources(potential ${theory} ${motion_times} slosh_solvers potential_run)
solver_sources(viscous_wave ${theory} ${motion_times} slosh_solvers "viscous_wave_run|theory/beyond_linear")
solver_sources(record slosh_solvers record_run slosh_results result_file)
solver_sources(stored ${importing} slosh_solvers "stored_run|external_facts")
solver_sources(external ${importing} slosh_peers "tank_file|motion_table" slosh_case ${motion_times}
               slosh_files "child_process|bound_cores"
               slosh_solvers "external_run|external_command|external_program|external_facts")
solver_sources(problems slosh_sph ".*" slosh_problems ".*")
