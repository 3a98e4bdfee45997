# One file per solver kind, beside the tool: a hash of the code that determines its answer, which is part of the key of
# each of its results (runs/run_key.hpp). The code of another solver, of metrics, gates, reports and campaigns is none
# of it, so that a change there leaves the results as they are.
#
#   hash_build(KIND OBJECT...)    writes slosh.builds/KIND of these object files
set(hash_objects ${CMAKE_CURRENT_LIST_DIR}/hash_objects.cmake)
function(hash_build kind)
  set(file ${CMAKE_CURRENT_BINARY_DIR}/slosh.builds/${kind})
  add_custom_command(OUTPUT ${file} DEPENDS ${ARGN} ${hash_objects} VERBATIM
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${file} "-DOBJECTS=$<JOIN:${ARGN},|>" -P ${hash_objects})
  set_property(TARGET slosh_builds APPEND PROPERTY SOURCES ${file})
endfunction()

# The objects of a library whose source files have these names: each is compiled by itself.
function(objects_of library names result)
  get_target_property(directory ${library} SOURCE_DIR)
  string(REPLACE "|" ";" files "${names}")
  list(TRANSFORM files REPLACE "(.+)" "${directory}/\\1.cpp")
  set_source_files_properties(${files} TARGET_DIRECTORY ${library} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set(${result} "$<FILTER:$<TARGET_OBJECTS:${library}>,INCLUDE,/(${names})[.]cpp[.]o$>" PARENT_SCOPE)
endfunction()

add_custom_target(slosh_builds)
objects_of(slosh_case "motion|cubic_spline|field_times" motion)
objects_of(slosh_case "motion/motion_times" motion_times)
objects_of(slosh_case "shape/sensor_place|shape/outline" places)
objects_of(slosh_results "result_file" results)
foreach(kind sph interfoam linear potential viscous_wave record external stored)
  objects_of(slosh_solvers "${kind}_run" ${kind}_run)
endforeach()
objects_of(slosh_solvers "sph_scene|snapshots|particles/state_file" sph_parts)
objects_of(slosh_input "units|tables/series_files|tables/table_head|tables/table_reader|tables/table_rows" tables)
objects_of(slosh_files "child_process|bound_cores" processes)
objects_of(slosh_solvers "theory/linear_flow_in_rectangle|theory/linear_flow_in_outline" linear_flows)
objects_of(slosh_solvers "theory/beyond_linear" beyond_linear)
objects_of(slosh_solvers "external_command|external_program" commands)
objects_of(slosh_solvers "external_facts" facts)
objects_of(slosh_peers "interfoam_tank" interfoam_tank)
objects_of(slosh_peers "tank_file|motion_table" tank_file)
set(sph $<TARGET_OBJECTS:slosh_sph>)
set(reference $<TARGET_OBJECTS:slosh_reference>)
set(problems $<TARGET_OBJECTS:slosh_problems>)

hash_build(sph ${sph} ${sph_run} ${sph_parts} ${motion} ${results})
hash_build(interfoam $<TARGET_OBJECTS:slosh_openfoam> $<TARGET_OBJECTS:slosh_dictionary_digest> ${interfoam_run} ${interfoam_tank} ${motion} ${motion_times} ${results})
hash_build(linear ${reference} ${linear_run} ${linear_flows} ${beyond_linear} ${motion} ${motion_times} ${places} ${results})
hash_build(potential ${reference} ${potential_run} ${motion} ${motion_times} ${results})
hash_build(viscous_wave ${reference} ${viscous_wave_run} ${beyond_linear} ${motion} ${motion_times} ${results})
hash_build(record ${record_run} ${results})
hash_build(stored $<TARGET_OBJECTS:slosh_import> ${tables} ${stored_run} ${facts} ${results})
hash_build(external $<TARGET_OBJECTS:slosh_import> ${tank_file} ${motion} ${motion_times} ${tables} ${external_run} ${processes} ${commands} ${facts} ${results})
# Of problems: those on SPH, and those on the metrics.
hash_build(problems ${sph} ${problems})
set(metrics "")
foreach(room series fits metrics convergence)
  list(APPEND metrics $<TARGET_OBJECTS:slosh_${room}>)
endforeach()
hash_build(metric_problems ${metrics} ${problems})
