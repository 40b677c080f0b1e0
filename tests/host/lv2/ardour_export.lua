-- SPDX-License-Identifier: MIT
-- For test_lv2_ardour.sh: Ardour without a screen plays the plugin from its virtual keyboard, records the notes,
-- exports them, chooses a preset and turns a control, exports again; with STEP=reopen it opens that session again
-- and exports it.
--
-- It prints what it sees, a fact a line. The folder is in $FOLDER.
local folder = os.getenv ("FOLDER")
local RATE = 48000
local BATTER, RESONANT = 2, 3 -- controls, behind freewheel and ready

local function add_track (session)
  local plugin = ARDOUR.LuaAPI.new_plugin_info ("urn:tabor:drum", ARDOUR.PluginType.LV2)
  local midi = ARDOUR.ChanCount (ARDOUR.DataType ("midi"), 1)
  local stereo = ARDOUR.ChanCount (ARDOUR.DataType ("audio"), 2)
  for track in session:new_midi_track (midi, stereo, true, plugin, nil, nil, 1, "Drum",
    ARDOUR.PresentationInfo.max_order, ARDOUR.TrackMode.Normal, true):iter () do
    return track
  end
end

local function send (port, bytes)
  local parser = ARDOUR.RawMidiParser ()
  for _, byte in ipairs (bytes) do
    if parser:process_byte (byte) then port:write (parser:midi_buffer (), parser:buffer_size (), 0) end
  end
end

local function wait (seconds) ARDOUR.LuaAPI.usleep (math.floor (1e6 * seconds)) end

local function record (session, track)
  local group = PBD.GroupControlDisposition.NoGroup
  local port = AudioEngine:get_port_by_name ("x-virtual-keyboard"):to_asyncmidiport ()
  track:input ():midi (0):connect ("x-virtual-keyboard")
  track:rec_enable_control ():set_value (1, group)
  session:maybe_enable_record (true)
  session:request_roll (ARDOUR.TransportRequestSource.TRS_UI)
  wait (1)
  for _ = 1, 3 do
    send (port, { 0x99, 38, 100 })
    wait (0.2)
    send (port, { 0x89, 38, 64 })
    wait (0.3)
  end
  session:request_stop (false, false, ARDOUR.TransportRequestSource.TRS_UI)
  wait (1)
  track:rec_enable_control ():set_value (0, group)
end

local function export (session, name)
  local export = session:simple_export ()
  export:set_name (name)
  export:set_folder (folder)
  export:set_range (0, 3 * RATE)
  print ("exported", name, export:run_export ())
end

local function the_track (session)
  for route in session:get_routes ():iter () do
    if route:name () == "Drum" then return route end
  end
end

local function print_tensions (when, insert)
  local batter = ARDOUR.LuaAPI.get_processor_param (insert, BATTER)
  local resonant = ARDOUR.LuaAPI.get_processor_param (insert, RESONANT)
  print (when, batter, resonant)
end

local function make ()
  local session = create_session (folder .. "/session", "session", RATE)
  local track = add_track (session)
  local insert = track:nth_plugin (0)
  print ("plugin", insert:name ())
  record (session, track)
  export (session, "snare")
  local plugin = insert:to_insert ():plugin (0)
  print ("preset", plugin:load_preset (plugin:preset_by_label ("tom-12")))
  wait (1)
  ARDOUR.LuaAPI.set_processor_param (insert, RESONANT, 2100)
  wait (2)
  print_tensions ("turned", insert)
  export (session, "tom")
  session:save_state ("")
end

local function reopen ()
  local session = load_session (folder .. "/session", "session")
  print_tensions ("reopened", the_track (session):nth_plugin (0))
  export (session, "reopened")
end

AudioEngine:set_backend ("None (Dummy)", "", "")
if os.getenv ("STEP") == "reopen" then reopen () else make () end
close_session ()
quit ()
