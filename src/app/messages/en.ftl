### Everything that the page says, in English. The other languages are translations of this file, with the same names.
###
### A line is `name = sentence`; what follows `#` explains it. Correct the sentence and leave the name. In braces stands
### what the page puts in: `{ $slot }`. Where a sentence depends on it, each of its forms has a line: `[one]` and
### `[other]` are the plurals of the language, `[0]` is none, and `*` marks the form for all else:
###
###     bench_tried =
###         { $count ->
###             [one] { $count } position was tried.
###            *[other] { $count } positions were tried.
###         }
###
### `{ help_open }` puts in another sentence. A figure and its unit stay on one line by themselves.
### The syntax is Fluent: https://projectfluent.org/fluent/guide/

## Moving servos and motor from the page.

bench_slots = Move to
bench_elsewhere = Servos and motor work with { $memory }, which flies next. Show { $memory } to move them.
bench_trim = Trim at { $slot }
bench_at = Servos at { $slot }
bench_atNone = It is not known where the servos stand.
bench_moveMaybe = No answer came. The servos may have moved anyway. Look at the model.
bench_unlocked = The motor is unlocked. The propeller may start.
bench_unlockMaybe = No answer came. The motor may be unlocked anyway. Keep away from the propeller.
bench_jumped = The timer acknowledged the jump.
bench_here = servos here
# A change that no servo follows: it is not in the timer.
bench_waits = Waits for Write.
bench_bring = Move the servos to { $slot }
bench_follow = Servos follow the positions
bench_followHint = First the page reads the timer and keeps a backup. Then each position that you change where the servos stand is stored at once, and its servo moves.
bench_followingNow = Following: a position that you change where the servos stand is stored at once.
bench_stopFollowing = Stop following
bench_ended_over = The servos no longer follow.
bench_ended_memory = The servos no longer follow: another memory is current, or may be.
bench_ended_strayed = Another memory became current while the servos followed. It may have taken some of the positions: look at all of it before you fly it.
bench_ended_unlike = The servos no longer follow: the timer did not do what it acknowledged.
bench_ended_failed = The servos no longer follow: the timer did not answer.
bench_notTaken = { $field } holds { $held }, not { $wanted }.
# $more: how many there are besides those that are named.
bench_beside =
    { $more ->
        [0] Changed beside it: { $named }.
        [one] Changed beside it: { $named }; and { $more } more value.
       *[other] Changed beside it: { $named }; and { $more } more values.
    }
# $more: how many there are besides those that are named.
bench_triedHere =
    { $more ->
        [0] Tried: { $named }.
        [one] Tried: { $named }; and { $more } more position.
       *[other] Tried: { $named }; and { $more } more positions.
    }
bench_triedAndWaiting =
    { $waiting ->
        [0] { $tried } tried in the timer
        [one] { $tried } tried in the timer, { $waiting } waits for Write
       *[other] { $tried } tried in the timer, { $waiting } wait for Write
    }
# In a timer that is not connected.
bench_triedIn = Positions were tried in { $memory }.
bench_decide = Keep what was tried, or put back what the timer held before?
bench_keep = Keep it
bench_putBack = Put it back…
bench_unlock = Hold to UNLOCK
bench_unlockHold = Keep holding
bench_unlockHint = The propeller may start. Hold the model, keep your hands away from the propeller, then press and hold.
bench_experimental = Experimental
bench_jumpHint = Jumps to the function after an early DT. Its exact effect is not documented: servos may move.
bench_jump = Jump…
bench_jumpSure = Send the jump now

## The log of flights.

flights_title = Flights
flights_empty_title = No flight logged yet.
flights_empty_advice = Read or write a timer, then press “{ flights_flying_button }”.
flights_failed = The browser cannot read the library now. Close other tabs of this page and try again.
# One tap logs a flight with what the timer holds.
flights_flying_button = Flying this
flights_flying_purpose = Logs a flight with what the timer holds.
flights_flying_logged = Flight logged { $time }
flights_flying_fillIn = Fill in
flights_flying_again = Fly this again
flights_row_round = Round { $round }
flights_row_wind = { $wind } m/s
flights_row_temperature = { $degrees } °C
flights_row_noResult = no result
# Since the flight of the same model before. $values: such as “3 values”.
flights_row_changed = { $values } changed
flights_row_otherTimer = another timer
flights_totals_flights =
    { $count ->
        [one] { $count } flight
       *[other] { $count } flights
    }
flights_totals_best = best { $time }
flights_totals_average = average { $time }
# $name: of a model or a saved program.
flights_filter_of = Flights of { $name }
flights_filter_clear = Show all
flights_form_title = Flight
flights_form_result = Result
flights_form_resultHint = Seconds, or minutes like 2:58.
flights_form_readAs = { $time }, { $seconds } s
# $facts: the next round and the last wind.
flights_form_propose = Note { $facts }
flights_form_full = Full round, 180 s
flights_form_round = Round
flights_form_flyOff = Fly-off
flights_form_wind = Wind
flights_form_windUnit = m/s
flights_form_temperature = Temperature
flights_form_temperatureUnit = °C
flights_form_when = Date, place, model
flights_form_date = Date and time
flights_form_noOffset = The time zone of the field is not known: this is the time of this device.
flights_form_place = Place
flights_form_flown = What was flown
flights_form_open = Open its program
flights_form_unreadable_not-a-number = Not a number.
flights_form_unreadable_not-a-time = Not a time: type seconds like 178, or minutes like 2:58.
flights_form_unreadable_too-fine = { unreadable_too-fine }
flights_form_range = { $min } to { $max } { $unit }.
flights_form_shortDt = DT was { $dt } on this flight.
flights_score_open = Score card
# The maximum of the day.
flights_score_maximum = Maximum of each round
flights_score_none = Without a maximum each result counts in full.
# $round: such as “Round 3”.
flights_score_maximumOf = Maximum of { $round }
flights_score_counted = Counted (s)
flights_score_notCounted = not counted
flights_score_count = Count this
flights_score_noRound = no round
flights_score_total = Total
flights_score_copy = Copy as text
flights_csv_save = Save as a table (CSV)
flights_csv_columns_date = Date
flights_csv_columns_time = Time
flights_csv_columns_zone = Time zone
flights_csv_columns_place = Place
flights_csv_columns_model = Model
flights_csv_columns_setting = Program
flights_csv_columns_timerClass = Timer class
flights_csv_columns_memory = Memory
flights_csv_columns_dt = DT (s)
flights_csv_columns_motorStop = Motor stop (s)
flights_csv_columns_wind = Wind (m/s)
flights_csv_columns_temperature = Temperature (°C)
flights_csv_columns_round = Round
flights_csv_columns_result = Result (s)
flights_csv_columns_maximum = Maximum (s)
flights_csv_columns_note = Note
flights_section_all = All its flights

## Values that are unusual, or cannot be written.

findings_time-not-whole = { unreadable_not-a-whole-number }
findings_time-out-of-range = It must be { $min } to { $max }.
findings_position-not-whole = { unreadable_not-a-whole-number }
findings_position-out-of-range = It must be { $min } to { $max }.
findings_throttle-not-whole = { unreadable_not-a-whole-number }
findings_throttle-out-of-range = It must be { $min } to { $max }.
findings_position-as-read = Read as { $value }, above the last step, { $max }. It stays as it is unless you change it.
findings_time-falls = This comes before the function above it ({ $previous }).
findings_time-repeats = The same time as the function above it, { $previous }.
findings_position-never-reached = The same time as the function above it, { $previous }. The positions of the function above are never reached.
findings_motor-stop-after-dt = The motor stops after DT ({ $dt }): the model comes down with the motor running.
findings_motor-run-long = The motor runs longer than { $limit }, the limit for F1Q.
findings_time-outside-manual = The manual allows { $min } to { $max }.
findings_time-too-fine = The manual gives steps of { $step }: the timer may round.
findings_dt-short = Shorter than { $limit }.
findings_dt-moves-nothing = No servo moves at DT: the timer does not bring the model down.
findings_throttle-unusual = More than { $limit } is unusual. The unit is not known.
findings_class-unknown = The class “{ $timerClass }” is not known: its rules were not checked.

## Why a text in a field is no value.

unreadable_empty = Empty: type a value.
unreadable_not-a-time = Not a time: type seconds like 12.5, or minutes like 2:05.
unreadable_too-fine = Finer than a hundredth of a second.
unreadable_not-a-whole-number = It must be a whole number.
unreadable_ambiguous = This can be read in several ways: choose one.

## For a page that cannot reach a timer here.

restWorks = Everything but the connection works here too.

## What an Android phone needs.

# The first versions of Chrome that reach a timer on Android: at all, and over Bluetooth, with the last one that does no
# more than that; and of Android itself, for a cable. Figures only.
firstVersions_android = 148
firstVersions_androidBluetooth = 138
firstVersions_lastBluetoothOnly = 147
firstVersions_androidCable = 17
android = Chrome { firstVersions_android } or later ({ firstVersions_androidBluetooth } to { firstVersions_lastBluetoothOnly } over Bluetooth only); a cable needs Android { firstVersions_androidCable }

## For every browser about which nothing more is known. docs/connection.md names the first versions.

unsupportedHere_title = This browser cannot reach a timer.
unsupportedHere_advice = On a computer use a current Chrome, Edge, Opera or Firefox; on a phone, Chrome on Android. { restWorks }

## Replaces the sentence above where the browser's name tells more.

unsupported_brave_title = Brave reaches a timer only when you allow it.
unsupported_brave_advice = Open brave://flags/#brave-web-serial-api, set it to Enabled and press Relaunch. { restWorks }
unsupported_ios_title = No browser on an iPhone or iPad can reach a timer.
unsupported_ios_advice = Use a computer, or Chrome on an Android phone. { restWorks }
unsupported_android_title = { unsupportedHere_title }
unsupported_android_advice = On Android, use { android }. { restWorks }

## What a saved program held before it was saved over.

versions_title = Earlier versions
versions_until = Until{"\u00a0"}{ $when }
# $change: the first value that was changed then: “DT: 3:00 min → 3:30 min”. $more: how many others.
versions_changed =
    { $more ->
        [0] then { $change }
       *[other] then { $change } and { $more }{"\u00a0"}more
    }
versions_otherLayout = then values for another timer
versions_same = The saved program holds this now.
versions_goBack = Go back to this

## Two programs side by side.

compare_title = Compare
compare_open = Compare…
compare_second = with
compare_screen = On the screen
compare_timer = Timer, { $memory }
compare_groups_now = Now
compare_groups_settings = Saved programs
compare_setting = { $model } · { $name }
compare_backup = { $memory } · { $when }
compare_backupOf = { $model } · { $memory } · { $when }
compare_nothing = This device has no other program of this class and layout.
# A button beside a value of the other program.
compare_take = Take
# The same for a screen reader, which does not know the row.
compare_takeOf = Take { $value } for { $field }
compare_takeHint = Take copies a value into the program on the screen.

## How a backup differs from what its timer holds.

# $when: “now”, or the day of the last reading.
modelBackups_same = as in the timer { $when }
modelBackups_differs =
    { $count ->
        [one] { $count } value differs from the timer { $when }
       *[other] { $count } values differ from the timer { $when }
    }
modelBackups_now = now


## Undo, redo, and edits of many fields at once.

edits_redoButton = Redo
edits_undo = Undo { $step }
edits_redo = Redo { $step }
edits_steps_change = change of { $what }
edits_steps_shift = shift from { $what } by { $by }
edits_steps_step-servo = { $what } by { $steps }
# $from: the first function that it was done to.
edits_steps_step-servo-from = { $what } by { $steps }, from { $from }
edits_steps_paste = paste of { $count }
edits_steps_fill = fill down of { $count }
edits_steps_revert-all = putting back everything
edits_steps_open = opening { $what }
edits_steps_keep-tried = keeping what was tried
# What was opened, or copied.
edits_opened = “{ $name }”
edits_openedUnnamed = another program
edits_refused_start = The start has no time to change.
edits_refused_later-out-of-range = A later function would be outside { $min } to { $max }.
edits_refused_unreadable = A text that is no value is in the way. Correct it first.
edits_refused_interval-disagrees = This interval does not fit the times of the two rows.
edits_refused_no-place = The program has no such place.
edits_refused_twice = This place comes twice, with different values.
edits_refused_too-large = The table is too large: at most { $cells } cells are read. The rest was left out.
edits_beforeLaunch = This would be before launch.
edits_nothingDone = Nothing was changed.
edits_cells =
    { $count ->
        [one] { $count } value
       *[other] { $count } values
    }
# “DT: 3:00 min → 6:00 min”.
edits_change = { $field }: { $from } → { $to }
edits_field_putBack = Put back { $field }
# Names a button that shows the figure: its name has to hold what can be read on it.
edits_field_putBackTo = Put { $field } back to { $figure }
edits_sheet_title = Keys for { $field }
edits_sheet_erase = Delete the last digit
edits_sheet_putBack = Put back
edits_sheet_selectRange = Select range
# Where the focus goes: in the same row, or in the row above or below.
edits_sheet_goTo = Go to { $name }
edits_table_explain = What the values are
edits_table_interval = After
# In the cell of an interval: the short name of the row that it counts from.
edits_table_countedFrom = from { $row }
# Where there is room for only one of the two columns.
edits_table_switch = Time or After
edits_table_intervalOf = { $slot } interval
edits_table_range_title = Selected range
edits_table_range_pick = Now tap another cell.
# $cells: rows, or functions.
edits_table_range_size = { $cells }, { $columns }
edits_table_range_functions =
    { $count ->
        [one] { $count } function
       *[other] { $count } functions
    }
edits_table_range_rows =
    { $count ->
        [one] { $count } row
       *[other] { $count } rows
    }
edits_table_range_columns =
    { $count ->
        [one] { $count } column
       *[other] { $count } columns
    }
edits_table_range_paste = Paste…
edits_table_range_fillDown = Fill down
edits_table_range_clipboardClosed = There is nothing to paste that this page may see. Tap the first field and paste there.
# Of a row or a servo.
edits_table_tools = Tools for { $name }
edits_stepServo_title = All positions of { $servo }
edits_stepServo_now = Now { $position }
edits_stepServo_nowRange = Now { $lowest } to { $highest }
edits_stepServo_by = By, in steps
edits_stepServo_step = Step
edits_stepServo_which = Which
edits_stepServo_all = All functions
edits_stepServo_from = From { $slot } on
# What would not go as far.
edits_stepServo_stops =
    { $count ->
        [one] { $steps }: { $what } stops at { $at }.
       *[other] { $steps }: { $what } stop at { $at }.
    }
edits_shift_open = Shift…
# What is shifted: a row and all rows after it. DT is the last.
edits_shift_from =
    { $isLast ->
        [true] { $row }
       *[false] { $row } and all after
    }
edits_shift_by = By, in seconds
edits_shift_earlier = Earlier
edits_shift_later = Later
edits_shift_moveDt = Move DT too
# Usually they follow each other.
edits_shift_function = function { $number }
edits_shift_functionRange = functions { $first } to { $last }
edits_shift_functions = functions { $numbers }
edits_shift_moved =
    { $later ->
        [true] Moved { $time }{" "}s later
       *[false] Moved { $time }{" "}s earlier
    }
# Above names of rows and columns in the copied text, each with a choice beside it.
edits_pasting_asks = These names are not known. Say what they mean:
edits_pasting_choose = Choose
edits_pasting_leaveOut = Leave out
edits_pasting_table = What goes where
edits_pasting_lead =
    { $count ->
        [0] This changes nothing.
        [one] This changes { $count } value.
       *[other] This changes { $count } values.
    }
# In a table, an ambiguous text is read in one way only, so the page says which.
edits_pasting_reading = { $field }: “{ $text }” is read as { $time }.
edits_pasting_problems = This cannot be pasted:
# Where a problem is that belongs to no field: in the text that was copied.
edits_pasting_place = Row { $row }, column { $column } of the copied text
edits_pasting_problem = { $place }: { $reason }
# $text: what was copied.
edits_pasting_problemOf = { $place }, “{ $text }”: { $reason }
edits_pasting_apply = Paste
edits_presets_title = DT presets
edits_presets_use = DT { $time }
edits_presets_refused = Type times such as 20 s or 2:30, up to 10:55 min, at most 24.
edits_fix = Set to { $value }
edits_fixOf = Set to { $value }: { $field }

## The library as files: export, import, and the reminder to export.

files_export_all = Export all…
files_export_one = Export…
# Given to the browser as a download. It does not say whether it has saved the file.
files_export_downloaded = “{ $name }” goes to your downloads: { $what }. Check that it is there.
# Added to the name of the program that wrote a file.
files_export_without = without { $kind }
# Kinds of what the library has, inside a sentence.
files_export_kinds_models = models
files_export_kinds_settings = programs
files_export_kinds_flights = flights
files_export_partly = “{ $name }” is not complete. It holds { $what }. The browser cannot read the { $missing } now: close other tabs of this page, and export again.
# Joins what is missing.
files_export_and = { $first } and { $next }
files_export_tooLarge = The library is too large for one file. Export its models one by one.
files_export_failed = The file could not be made. Load the page again and try once more.
files_import_button = Import…
files_import_title = Import { $name }
files_import_lead = Saved { $date }. It holds { $what }.
files_import_leadNothing = Saved { $date }. It holds nothing.
files_import_ignored =
    { $count ->
        [one] { $count } entry is of a newer version of this page and is left out.
       *[other] { $count } entries are of a newer version of this page and are left out.
    }
files_import_nothing = You have all of this already.
files_import_differs = What differs
files_import_ways_newer = Take the newer
files_import_ways_both = Keep both
# The facts of a model: its name, notes, servos.
files_import_itself = the model itself
files_import_flightOf = flight of { $day }
files_import_wayText_newer = What is newer here, or has the same date, stays.
files_import_wayText_both = Both stay. The one from the file gets a number after its name.
files_import_unknownModel = A model that is not here
files_import_group_fresh = New: { $what }
files_import_group_same = The same: { $what }
files_import_group_fileNewer = Newer in the file: { $what }
files_import_group_deviceNewer = Not newer in the file: { $what }
# An entry that has another name here than in the file.
files_import_group_fileName = { $file } (here: { $here })
files_import_take =
    { $count ->
        [0] Nothing to import
       *[other] Import { $count }
    }
# Why there is nothing to import, and what to do.
files_import_allStays = Nothing in the file is newer. Choose “{ files_import_ways_both }” to import it, too.
files_import_done = Imported from “{ $name }”: { $what }.
files_import_undo = Undo the import
files_import_undone = The import was undone. Later changes stay.
files_refused_title = { $name } cannot be imported
files_refused_nothing = Nothing was imported.
files_refused_again = Export the file again, or ask its sender for a new one.
# $found: as it stands in the file.
files_refused_fault = Line{"\u00a0"}{ $line }: found { $found }.
# $place: the parts of a place that follow, with commas between them.
files_refused_faultIn = Line{"\u00a0"}{ $line }, { $place }: found { $found }.
# Before what the check of the file says, in English.
files_refused_wanted = Expected:
files_refused_place_entry =
    { $kind ->
        [models] Model “{ $name }”
        [settings] Program “{ $name }”
       *[flights] Flight “{ $name }”
    }
# An entry without a name, by its place among those of its kind.
files_refused_place_unnamed =
    { $kind ->
        [models] Model { $number } in the file
        [settings] Program { $number } in the file
       *[flights] Flight { $number } in the file
    }
files_refused_place_function = function { $number }
files_refused_damaged = The file is damaged or not complete.
files_refused_files_too-large = The file is too large for a library.
files_refused_files_gone = The file could not be read. Choose it again.
files_refused_files_several = Import one file at a time.
files_refused_format = This is not a library file of Sidus Timer.
files_refused_newer = A newer version of this page made it. Load the page again while you are online.
files_reminder =
    { $changes ->
        [one] { $changes } change of the library is only on this device. If you lose it, only a file brings it back.
       *[other] { $changes } changes of the library are only on this device. If you lose it, only a file brings them back.
    }

## For the time before the other sentences are loaded.

first_failed = The page is not complete. Is there a network?
first_again = Load it again

## What a system shows of the installed page: public/manifest.webmanifest has the same in English.

manifest_description = Sets Sidus F1Q, F1B and F1E free-flight timers: reads what a timer holds, takes your changes, writes them, reads them back and compares. Keeps your models and programs on this device. Works without a network.
manifest_connect = Connect a timer
manifest_connectShort = Connect
manifest_connectWhat = The start, with Connect at hand
manifest_library = Library
manifest_libraryWhat = Models and their programs
manifest_simulated = Simulated timer
manifest_simulatedWhat = The start, with the simulated timers at hand
manifest_pictures_program = The program of a timer, with two changes marked
manifest_pictures_write = What a write will change, before it is written
manifest_pictures_programPhone = The whole program on a phone
manifest_pictures_writePhone = What a write will change, on a phone

## The help inside the page.

guide_pages_checklist = Checklist
guide_pages_trouble = Trouble
guide_pages_words = Values
guide_pages_steps = First steps
guide_nav = Help pages

## What a new pilot is told.

firstSteps_1 = Read: press Connect, wake the timer, hold the infrared head close. Reading changes nothing and moves nothing.
firstSteps_2 = Write: type new values, press Write, look at every difference. “Verified” means: the timer was read again and holds what you want.
firstSteps_3 = Fly: the top shows which memory flies next, and its DT. The page needs no network, and nothing leaves this device.

## The values of a program, with unit and range.

values_function_text = A step of the flight: at its time each servo goes to its position. To skip one, give it the positions of the function before.
values_function_range = Usually start, nine functions and DT.
values_time_text = When a function begins, counted from launch. Type 12.5 or 2:05. For F1B and F1E it is not known from where the timer counts.
values_time_range = By the manuals. F1Q: 0.1 to 99.9 s. F1B: 0.01 to 9.99 s for functions 1 and 2, then 0.1 to 99.9 s. F1E: not known.
values_after_text = The time since the function before. All later functions move with it, DT does not.
values_position_name = Position
values_position_text = Where a servo stands. The angle of a step depends on servo and linkage: try it on the bench.
values_position_range = 0 to 130 steps.
values_motorStop_text = F1Q: when the motor stops, counted from launch. No servo moves with it.
values_motorStop_range = By the manual 0.1 to 99.9 s, in steps of 0.1 s.
values_dt_text = The dethermaliser: when it brings the model down, counted from launch. Red when shorter than your limit.
values_dt_range = 1 to 720 s by the manual. More than 10:55 min cannot be sent.
values_idleThrottle_text = F1Q: probably how fast the motor turns while the start switch is held.
values_idleThrottle_range = The page assumes 0 to 100. The unit is not known.
values_memory_text = A timer has several memories, each with one program. The selected one flies next. A look at another one selects it and goes back; if that is interrupted, the page says which one may fly next.
values_memory_range = Usually four, M1 to M4. Older timers have five.

## What a pilot checks before a flight.

checklist_lead = Tick each item. The ticks are for one flight and are not kept.
checklist_items_memory = The right memory flies next.
checklist_items_dtTime = I have said the DT time aloud.
checklist_items_surfaces = Wing, tailplane and rudder sit firmly and stand as they should.
checklist_items_battery = The battery is charged, and its plug is in all the way.
checklist_items_dtSeen = I have seen the servo move to DT.
checklist_items_radioDt = I have tried the radio DT, if there is one.
checklist_items_switch = I pressed the start switch five times, and it sprang back each time.
checklist_items_propeller = The propeller is fixed firmly and turns freely. Nobody is in front of it.
checklist_known_now = { $memory } flies next, DT{"\u00a0"}{ $dt }, read { $time }.
checklist_known_onceAt = As last read { $time }: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_once = As last read: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_not = It is not known what { $memory } holds. Read it before you fly.
checklist_known_nothing = No timer has been read. Connect to see its memory and DT here.
checklist_known_unwritten =
    { $count ->
        [one] { $count } change not in the timer yet.
       *[other] { $count } changes not in the timer yet.
    }
checklist_left =
    { $count ->
        [one] { $count } item left
       *[other] { $count } items left
    }
checklist_done = All ticked. Good flight.
checklist_again = Clear all ticks

## Problems as a pilot sees them, and what to do.

troubles_symptoms_noAnswer_title = The timer does not answer
troubles_symptoms_noAdapter_title = The page does not find the adapter
troubles_symptoms_refused_title = The adapter does not open
troubles_symptoms_wrongValues_title = The values look wrong
troubles_symptoms_wrongValues_steps_1 = Look at the top: which memory is shown, and which flies next?
troubles_symptoms_wrongValues_steps_2 = Press “{ program_read }”.
troubles_symptoms_wrongValues_steps_3 = Do the times fall from row to row? The page then asks how to read them.
troubles_symptoms_wrongValues_steps_4 = On F1B and F1E compare the times with the handheld programmer.
troubles_symptoms_cutOff_title = The write was interrupted
troubles_symptoms_cutOff_steps_1 = Do not fly this model yet. Connect: the page reads the timer, then offers to finish the write or to go back.
troubles_symptoms_cutOff_steps_2 = What the timer held before is under Memories, Backups.
troubles_symptoms_noDt_title = DT does not come, or comes at the wrong time
troubles_symptoms_noDt_steps_1 = Look at the top: it says which memory flies next, and its DT. Another memory has another DT.
troubles_symptoms_noDt_steps_2 = Does the start switch spring back each time? While it is held, the sequence does not begin, and no DT comes.
troubles_symptoms_noDt_steps_3 = Is the battery charged, and its plug in all the way? When the timer does not run, no DT comes.
troubles_symptoms_noDt_steps_4 = Hold the model safely and press the DT row in the Bench view. Does the servo go there, and does it release what it holds?
troubles_symptoms_noDt_steps_5 = Take the propeller off and let the timer run to its end. Do not fly before you have seen the servo move at the time of DT.
troubles_symptoms_noMove_title = A servo does not move
troubles_symptoms_noMove_steps_1 = Hold the model and press its row on the bench. Nothing moves? Look at plug and battery. Moves there, but not in flight? It has the same position as the function before.
troubles_symptoms_noMove_steps_2 = Does it go to another place than the table says? A timer may store a position only for the function at which the servos stand. The page then offers to move the servos while it writes.
troubles_symptoms_noMove_steps_3 = Does it hum, or stop too early? The linkage may block it: try a smaller movement.
troubles_symptoms_noMotor_title = The motor does not start
troubles_symptoms_noMotor_steps_1 = After a flight the timer locks the motor. To free it, hold the model and keep your hands away from the propeller: it may start. Then hold the button “{ bench_unlock }” in the Bench view.
troubles_symptoms_noMotor_steps_2 = Has the start switch sprung back? While it is held, the motor only idles.
troubles_symptoms_noMotor_steps_3 = Is the motor stop long enough? At 0.1 s the motor stops as soon as it has started.
troubles_symptoms_noLibrary_title = My models and programs are not here
troubles_symptoms_noLibrary_steps_1 = Empty the search field, press Archive.
troubles_symptoms_noLibrary_steps_2 = Each browser, profile and address has its own library; a private window deletes it.
troubles_symptoms_noLibrary_steps_3 = On another device, or when it is lost: Import, and the file of your last export.

## What to do, step by step, when a timer cannot be reached.

help_title = What to do
help_steps_programs = Close other tabs and programs that use the adapter, such as Arduino IDE, PuTTY, a 3D printer program or a drone configurator.
help_steps_replug = Unplug the adapter, wait five seconds, plug it in again. If that does not help, restart the computer.
help_steps_cable = Plug the adapter in directly, without a hub, and try another cable. Many USB cables only charge.
help_steps_windows = Windows: open the Device Manager. A yellow mark on the adapter means that its driver is missing: connect to the internet and run Windows Update.
help_steps_mac = Mac: allow the accessory when the Mac asks. An old macOS needs the driver of the maker.
help_steps_linux = Linux may not let you use the adapter. Run this, then log out and in again.
help_steps_linux-container = The Linux of a Chromebook may have taken the adapter. Switch the adapter off in the Settings, under Linux development environment, Manage USB devices.
help_steps_android = On Android, use { android }. { restWorks }
help_steps_bluetooth = Bluetooth: pair the adapter in the settings of the system (code 1234 or 0000), keep it on and near, and switch Bluetooth off on other devices that use it.
help_steps_firefox-finds = Firefox finds no Bluetooth adapters, and none at all when it comes from the Ubuntu store. Use Chrome.
help_steps_firefox-reload = Firefox keeps an adapter that has failed. Load this page again. What you typed is kept.
help_steps_switch = { link_stages_steps_switch }
help_steps_near = { link_stages_steps_near }
help_steps_battery = Is the battery of the timer charged and plugged in? When its battery is empty, a timer stands at its DT position.
help_steps_restarts = Some adapters restart each time their port is opened (DTR resets them), and hear nothing for some seconds. If yours does, set its rate in Settings, “{ ports_settings }”: then the port is opened only once. The page itself leaves DTR as the browser sets it.
help_steps_usual-settings = Open Settings, “{ ports_settings }”, and press “{ ports_reset }”: the page then finds the rate by itself.
help_steps_report = If it happens again: Settings, Expert, Line, “{ line_copyReport }”. Send it to:
help_steps_address = Open this address in a tab:
# The link to the steps for every system: docs/connection.md.
help_page = All steps, for every system

## For when the browser does not store, or give back, what it should.

keeping_title = This browser does not keep everything.
keeping_notKept = What you type, backups and the note of an interrupted write last only while this page is open. Export the library. Then close other tabs of this page, or make room on this device.
keeping_notKnown = The browser does not say whether it keeps what you do. Take it as not kept, and export the library.
keeping_oneTab = Use one tab of this page only.
keeping_emptied = The browser has deleted what it kept for this page. Export what you still see.
keeping_export = Export the library…

## Stored data that cannot be read.

aside_title =
    { $count ->
        [one] 1 record could not be read. It is set aside, not deleted.
       *[other] { $count } records could not be read. They are set aside, not deleted.
    }
aside_write = It includes the note of an interrupted write: read the timer before you fly.
aside_save = Save to a file

## “2 models, 1 program”: only kinds that there are.

counted_models =
    { $count ->
        [one] { $count }{"\u00a0"}model
       *[other] { $count }{"\u00a0"}models
    }
counted_settings =
    { $count ->
        [one] { $count }{"\u00a0"}program
       *[other] { $count }{"\u00a0"}programs
    }
counted_flights =
    { $count ->
        [one] { $count }{"\u00a0"}flight
       *[other] { $count }{"\u00a0"}flights
    }
counted_backups =
    { $count ->
        [one] { $count }{"\u00a0"}backup
       *[other] { $count }{"\u00a0"}backups
    }

## What was deleted a moment ago.

removed = Deleted: { $what }.

## Deletes everything that this device keeps.

erase_open = Delete everything on this device…
erase_lead = This deletes all models, programs, flights, backups, unwritten changes and choices of this page from this browser. It cannot be undone. Timers keep what they hold.
erase_uncertain = A write was interrupted, and it is not known what that timer holds. Without the note of that write this page cannot warn you: read that timer before you fly.
erase_start = Delete everything
erase_running = Deleting
erase_failed = Not everything could be deleted. Close other tabs of this page and try again, or delete its data in the settings of the browser.

## For a page that is shown inside another page.

framed_title = Sidus Timer works only in its own tab: another page could cover what you see of your timer.
framed_open = Open Sidus Timer in its own tab

## What is known about the content of a timer, and what is not.

# For a memory whose content is uncertain.
knowledge_title = Not certain
knowledge_uncertain = It is not known what { $memory } holds: { $values }.
knowledge_noFly = Do not fly before it is read.
knowledge_since = A write was interrupted on { $time }.
knowledge_thisMemory = the current memory
# For a timer that is not connected.
knowledge_memoryOf = { $memory } of { $timer }
knowledge_timer_here = the { $name } { $firmware }
knowledge_timer_simulated = the simulated { $name } { $firmware }
# While another timer of the same kind is connected.
knowledge_otherTimer_here = another { $name } { $firmware }
knowledge_otherTimer_simulated = another simulated { $name } { $firmware }
knowledge_motorStop = motor stop
knowledge_either = { $name } is { $before } or { $goal }
# $named: how some values are not certain. $more: how many others are not.
knowledge_list =
    { $more ->
        [one] { $named }, and { $more }{"\u00a0"}more{"\u00a0"}value is not certain
       *[other] { $named }, and { $more }{"\u00a0"}more{"\u00a0"}values are not certain
    }
knowledge_and = { $first } and { $next }
knowledge_connect = Connect and read
knowledge_forget = Forget this…
knowledge_forgetSure = Forget it only if you have read that timer elsewhere, or no longer have it.
knowledge_forgetNow = Forget it now
# In place of “No changes”.
knowledge_verified = As in the timer, verified { $time }
knowledge_readAt = As in the timer, read { $time }
knowledge_lastReadAt = As last read { $time }
# When it was not kept when that was.
knowledge_lastRead = As last read
# For a setting of the library, by its model and name.
knowledge_ofSetting =
    { $changes ->
        [0] { $name }: saved
        [one] { $name }: { $changes } change not saved
       *[other] { $name }: { $changes } changes not saved
    }
# For a program that is no longer what was saved under this name.
knowledge_changed = { $name }, changed
knowledge_ofModel = { $name } of { $model }
# For a program that was made here.
knowledge_made = New program, in no timer yet
knowledge_unknown = Not known what { $memory } holds
knowledge_unfinished =
    { $count ->
        [one] { $count } field has no value yet
       *[other] { $count } fields have no value yet
    }
knowledge_hints_now = Marked fields differ from what the timer holds.
knowledge_hints_onceAt = Marked fields differ from what was last read, { $time }.
knowledge_hints_once = Marked fields differ from what was last read.
knowledge_marks_now = was { $value }
knowledge_marks_once = last read { $value }
# For screen readers.
knowledge_notCertain = , not certain now
knowledge_held_now = Timer holds
knowledge_held_once = Last read

## Why a program of the library or from a link cannot be opened now.

obstacles_busy = This page is reading, writing or looking for a timer. Wait until it has finished.
obstacles_following = The servos follow. Stop that first.
obstacles_not-fitting = { notFitting }

## Models and their saved programs.

library_unread = The browser cannot read the library now. Close other tabs of this page and try again.
library_empty_title = No model yet
library_empty_lead = A model holds its programs, with names and notes. They are kept only on this device.
library_empty_hint = Make a model, or read a timer and save its program.
library_search_label = Search programs
library_search_nothing = No program has all of these words.
library_models_title = Models
library_models_all = All models
# The way back to what stands above.
library_models_make = New model…
library_models_settings =
    { $count ->
        [one] { $count } program
       *[other] { $count } programs
    }
library_models_archive = Archive ({ $count })
library_models_archived = archived
library_models_latest = Last changed
library_list_open = on the screen
library_model_timerClass = Class
library_model_noClass = Not given
# Used where the model's name stands above its programs.
library_model_facts = About this model
library_model_noSettings = No program yet.
library_model_servos = Servos
library_model_servosUnknown = Save a program of this model first.
library_model_servoWay = { $low } to { $high } steps
library_model_archive = Archive
library_model_unarchive = Take out of the archive
library_model_remove = Delete the model
library_model_withSettings =
    { $count ->
        [one] Its program is deleted with it. Undo brings both back.
       *[other] Its { $count }{"\u00a0"}programs are deleted with it. Undo brings all back.
    }
library_setting_isOpen = On the screen: look at it
# $count: of the values on the screen that differ from the saved ones.
library_setting_loadAgain =
    { $count ->
        [one] Open again: { $count } value goes back
       *[other] Open again: { $count } values go back
    }
library_setting_tags = Tags, separated by commas
library_setting_from_typed = typed
library_setting_from_timer = read from a timer
library_setting_from_simulated = read from a simulated timer
library_setting_from_backup = from a backup
library_setting_from_file = from a file
library_setting_from_link = from a link
library_setting_origin = { $source }, { $time }
library_setting_notShown = It could not be opened. Try again.
library_setting_gone = It is not in the library any more.
# Used while nothing of the library is open.
library_save_open = Save…
# The button names what it overwrites. $model: empty for none.
# $program: its name, and the model's.
library_save_over = Save over { $program }
library_save_undo = Take back the save of { $name }
# A tick: values of one model would go under the name of another.
library_save_crossing = These are values of { $from }. Save them under { $to }.
library_save_asNew = Save as new…
# $model: empty for none.
# $program: its name, and the model's.
library_save_taken = There is already a program { $program }. Type another name, or:
library_save_replace = Save over it. Its values stay as an earlier version.
library_save_name =
    { $of ->
        [program] Name of the program
       *[model] Name of the model
    }
library_save_namePlace = For example: fly-off, calm
library_save_notSavable = A field has no value. Correct it first.
library_save_state =
    { $changes ->
        [0] { $name }: saved
        [one] { $name }: { $changes } change not saved
       *[other] { $name }: { $changes } changes not saved
    }
library_nameNeeded = It needs a name.

## The log of the line.

line_empty = Nothing to show.
line_unused = Nothing on the line yet. You can also load a recording and replay it as a timer.
line_all = Everything
line_out = To the timer
line_in = From the timer
line_damaged = Damaged
line_request = { $name } · { $letters }
line_reply = { $name }, reply · { $letters }
line_echo = { $name }, echo · { $letters }
line_unknown = Unknown letter { $letter }
line_names_GETTIMERS = Read times
line_names_SETTIMERS = Write times
line_names_GETSERVOPOS = Read positions
line_names_SETSERVO = Write a position
line_names_MOVETOFUNC = Move servos
line_names_GETSWVER = Identify
line_names_UNLOCK = Unlock motor
line_names_JUMP2 = Jump
line_names_GETMEMORY = Which memory
line_names_SETMEMORY = Select memory
line_names_GETLOWRPM = Read idle throttle
line_names_SETLOWRPM = Write idle throttle
line_rejected_noise = Damaged: noise
line_rejected_length = Damaged: impossible length
line_rejected_terminator = Damaged: no end where it should be
line_rejected_checksum = Damaged: wrong checksum
line_rejected_silence = Damaged: cut off
line_error_framing = Line error: framing
line_error_parity = Line error: parity
line_error_break = Line error: break
line_error_overrun = Line error: overrun, bytes were lost
line_error_other = Line error of another kind
line_position = { $slot }, { $servo }: { $steps } steps
line_motorStop = motor stop { $time }
line_reserved = reserved { $time }
line_functions = functions { $times }
line_identity = { $name }, firmware { $firmware }, { $functions } and DT, { $memories }, { $servos }
line_memories =
    { $count ->
        [one] { $count } memory
       *[other] { $count } memories
    }
line_memoryUnsaid = It does not say which.
line_idleThrottle = { $value }, unit unknown
line_idleThrottleUnsaid = It gives no value.
line_acknowledged = Acknowledged.
line_unreadable_wrong-length = Its content is longer or shorter than it should be.
line_unreadable_unknown-command = What it means is not known.
line_unreadable_unexpected-reply = It answers another request.
line_unreadable_bad-identity = What it says of the timer cannot be right.
line_unreadable_identity-needed = It can be read once the timer has said what it is.
line_unreadable_out-of-range = A value in it cannot be right.
line_unreadable_not-an-integer = { line_unreadable_out-of-range }
line_unreadable_wrong-count = { line_unreadable_out-of-range }
line_unreadable_wrong-type = { line_unreadable_out-of-range }
line_unreadable_unknown-word = Its content cannot be read.
line_unreadable_bad-capture = { line_unreadable_unknown-word }
line_unreadable_bad-file = { line_unreadable_unknown-word }
line_unreadable_bad-link = { line_unreadable_unknown-word }
line_unreadable_newer-version = { line_unreadable_unknown-word }
line_unreadable_too-large = { line_unreadable_unknown-word }
line_unreadable_duplicate = { line_unreadable_unknown-word }
line_goOn = Go on
line_came =
    { $number ->
        [one] Paused. { $number } entry since.
       *[other] Paused. { $number } entries since.
    }
line_clear = Clear
line_unidentified = unknown
line_load = Load…
line_filter = Show
line_searchHint = name or hex
line_counts_out =
    { $count ->
       *[other] { $count } to the timer
    }
line_counts_in =
    { $count ->
       *[other] { $count } from the timer
    }
line_counts_damaged =
    { $count ->
       *[other] { $count } damaged
    }
line_counts_errors =
    { $count ->
        [one] { $count } line error
       *[other] { $count } line errors
    }
line_recording =
    { $entries ->
        [one] { $name }: a recording of { $entries } entry.
       *[other] { $name }: a recording of { $entries } entries.
    }
line_replay = Replay it as a timer
line_cannotReplay = It cannot be replayed: the timer never says what it is.
line_back = Back to the live line
# $line: of the file, counted from 1.
line_noRecordingAt = Line { $line }: expected a time in seconds, > or <, and bytes in hex.
line_noRecording = This file is not a recording.
line_send_title = Send a frame by hand
line_send_lead = The page adds length and checksum.
line_send_bytes = Letter and data, in hex
line_send_faults_hex = Type two hex digits for each byte, 0 to 9 or A to F.
line_send_faults_too-long = A frame carries at most 252 bytes.
line_send_preview = Goes out as
line_send_send = Send…
line_send_confirmTitle = Send this frame to the timer?
line_send_danger = Servos may move, the propeller may start, and what the timer holds may change. The timer is read again afterwards.
line_send_confirm = Yes, send it once
line_send_sending = Sending
line_send_answered = Answered:
line_send_unanswered = No reply came. What the frame asked for may have happened anyway.
line_copyReport = Copy report

## From the ports to a timer that answers.

link_portNames_ftdi = FTDI adapter
link_portNames_cp210x = CP210x adapter (Silicon Labs)
link_portNames_ch340 = CH340 adapter (WCH)
link_portNames_pl2303 = PL2303 adapter (Prolific)
link_portNames_bluetooth = Bluetooth
link_portNames_usb = USB adapter
link_portNames_other = Serial port
link_stages_choosing = Choose the adapter of the timer
link_stages_openingLong_title = The adapter takes long to open
link_stages_openingLong_advice = Bluetooth: switch the adapter on, near. Cable: unplug it and plug it in again.
link_stages_asking = Asking at { $rate } baud.
# While waiting for an answer. Changes with each second.
link_stages_noAnswer = No answer for { $seconds } s. This page keeps asking and goes on by itself.
link_stages_open = The adapter is open
link_stages_steps_switch = Wake the timer: press its switch briefly
link_stages_steps_near = Hold the infrared head closer than 20 cm, out of the sun
link_stages_steps_other = Is the timer on another adapter?
link_refused = The page tries again for 15 seconds. Another program may have the adapter.
link_heard_title = Something is heard, but no timer answers.
link_heard_advice = Wake the timer and hold the head closer, out of the sun, or choose another adapter.
link_slow_title = A timer answers, but too slowly.
link_slow_advice = Its bytes come one by one at { $rate } baud, with gaps so long that no answer is whole in time. This page cannot read it. Try another adapter, or a cable in place of Bluetooth.
# The bytes that came in place of an answer.
link_itSaid = What came: { $bytes } (“{ $text }”).
link_trySelectBare = Try it without a correct checksum
link_lost_title = The connection to the adapter is lost.
link_lost_advice = Plug it in, or bring it near: the page goes on by itself. What you typed is kept.
link_status_off = Not connected
link_status_opening = Connecting
link_status_searching = Looking for the timer
link_status_away = Connection lost
link_status_closing = Disconnecting

## The known ports, and how they are opened.

ports_title = Known adapters
ports_forget = Forget
ports_settings = Serial settings
ports_settingsHint = Only for a special adapter. The page finds the rate by itself.
ports_rate = Rate
ports_findRate = Find it
ports_baud = { $rate } baud
ports_parity = Parity
ports_parities_none = None
ports_parities_even = Even
ports_parities_odd = Odd
ports_stopBits = Stop bits
ports_dtr = DTR
ports_rts = RTS
ports_signals_leave = As the browser sets it
ports_signals_on = On
ports_signals_off = Off
ports_reset = Usual settings

## What is known about the connected timer. Its numbers are in the report.

aboutTimer_title = About this timer
aboutTimer_damage = Damage seen on the line
aboutTimer_crowd = Another timer or programmer may be in the beam. Since then two readings must agree.
aboutTimer_found = What it did differently
aboutTimer_nothingFound = Nothing so far: it has done all that was asked in the usual way.
aboutTimer_quirkNames_timers-reply-66 = It answers with the letter of another command.
aboutTimer_quirkNames_unlock-reply-6a = { aboutTimer_quirkNames_timers-reply-66 }
aboutTimer_quirkNames_memory-unknown = It does not say which memory is current.
aboutTimer_quirkNames_memory-impossible = { aboutTimer_quirkNames_memory-unknown }
aboutTimer_quirkNames_bare-checksum = It does not answer about the idle throttle as usual.
aboutTimer_quirkNames_times-big-endian = Its times fall. With the two bytes of each swapped they would rise.
aboutTimer_quirkNames_servo-first = It takes the servo before the function when a position is written.
aboutTimer_quirkNames_servo-unanswered = It did not answer when a position was written.
aboutTimer_quirkNames_times-rounded = It rounds times.
aboutTimer_quirkNames_memories-from-one = It counts its memories from 1.
aboutTimer_quirkNames_positions-unchanged = It acknowledged positions but did not keep them.
aboutTimer_quirkNames_echo = The adapter sends back what it is sent.
aboutTimer_quirkNames_idle-throttle-unanswered = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_identity-unusual = What it says of itself has bytes that are not known.
aboutTimer_quirkNames_idle-throttle-malformed = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_replies-alike = Its replies to some requests are damaged, each in the same way.
aboutTimer_assumed = What is known to differ
aboutTimer_assumedHint = Remembered for this adapter and this kind of timer.
aboutTimer_forget = Forget what is known to differ
aboutTimer_assumptions_bigEndianTimes = The two bytes of each time are swapped
aboutTimer_assumptions_servoFirst = { aboutTimer_quirkNames_servo-first }
aboutTimer_assumptions_memoriesFromOne = { aboutTimer_quirkNames_memories-from-one }
aboutTimer_assumptions_bareChecksumRequests = “Select memory” and “write idle throttle” are sent without a correct checksum
aboutTimer_assumptions_positionsNeedMove = Positions are kept only where the servos stand

## Which memory flies next, and what is known about the others.

nextFlight_badge = flies next
# Before the memory that flies next.
nextFlight_onScreen = This is { $memory }.
nextFlight_named = { $memory }, flies next
nextFlight_other = { $memory } flies next.
# While no timer is connected.
nextFlight_last = { $memory } was current when the timer last answered. It flies next unless something else has changed that.
nextFlight_original = When you connected it was { $original }.
nextFlight_originalUnknown = It is not known which one it was when you connected.
nextFlight_unknown = It is not known which memory flies next.
nextFlight_asked = { $memory } was selected last.
nextFlight_back = Back to { $original }
nextFlight_leaving_title = Before you disconnect
nextFlight_leaving_back = Back to { $original } and disconnect
nextFlight_leaving_failed = The timer did not go back to { $original }. It is still connected.

## The last reading of a memory that is not current.

look_read = { $memory }, read { $time }
look_notRead = { $memory } has not been read
# Above the two values that a field may have after an interrupted write.
look_either = Either
look_or = or
# $current: the memory that flies next.
look_lead = For looking only. { $current } flies next.
# Opens it in the table.
look_edit = Edit { $memory }
look_look = Look at { $memory }
look_hint = This selects { $memory }, reads it and goes back to { $current }.
look_fly = Make { $memory } fly next
look_show = Show { $memory }

## Jobs over several memories, and the backups.

memories_copy = Copy { $from } to { $to }
memories_restore = Restore a backup
memories_restoreAll = Restore all { $count }…
memories_plans_screen =
    { $keepsThrottle ->
        [true] { $to } will hold the times and positions on the screen. What { $to } holds now is backed up first. The idle throttle stays as it is.
       *[false] { $to } will hold the times and positions on the screen. What { $to } holds now is backed up first.
    }
memories_plans_copy = { $to } will hold the times and positions of { $from }, as read just now. What { $to } holds now is backed up first.
memories_plans_restore = This writes into { $names } what was backed up on { $time }. What is there now is backed up first.
# Said after what a plan does.
memories_atEnd = At the end { $current } flies next again.
memories_refused = Nothing can be written into { $memory }: no program can send these values.
memories_untouched = Nothing was written into { $memory }.
memories_stopped = What was not yet written is as it was.

## All memories of a timer at a glance.

overview_readAll = Read and keep all
overview_copyTo = Copy to…
overview_compareWith = Compare with { $memory }
overview_readAt = read { $time }
overview_notCertain = Not certain: a write into it was interrupted. Shown as before that write.
overview_edited = Shown and copied as the timer holds it, without your changes.
overview_same = They hold the same.
overview_differs =
    { $count ->
        [one] { $count } value differs.
       *[other] { $count } values differ.
    }

## How the timer writes its times: the question that no reading can answer.

byteOrder_title = The times of this timer fall from row to row.
byteOrder_advice = They would rise if the two bytes of each time were swapped. Compare with what you know of the timer, and choose before you write.
byteOrder_keep = They are right as shown
byteOrder_exchange = Swap them and read again

## Why there is no connection.

connection_unsupported_title = { unsupportedHere_title }
connection_unsupported_advice = { unsupportedHere_advice }
connection_insecure_title = The browser does not allow serial ports here.
connection_insecure_advice = { restWorks }
connection_policy_title = The server of this page forbids serial ports.
connection_policy_advice = { restWorks }
connection_nothing-chosen_title = No adapter was chosen.
connection_nothing-chosen_advice = Press Connect and choose the adapter. If it is not in the list, the steps below help.
connection_not-allowed_title = { connection_insecure_title }
connection_not-allowed_advice = Allow serial ports for this page in the settings of the browser, then press Connect again.
connection_busy_title = The adapter does not open.
connection_busy_advice = Most often another program or tab has it. Close that, then press Connect again.
connection_bad-settings_title = The adapter does not take these settings.
connection_bad-settings_advice = { help_steps_usual-settings }
connection_unplugged_title = The adapter cannot be reached.
connection_unplugged_advice = Unplug it, plug it in again and press Connect. What you typed is kept.
connection_bad-reply_title = { link_heard_title }
connection_bad-reply_advice = { link_heard_advice }
connection_lost_title = { connection_unplugged_title }
connection_lost_advice = { connection_unplugged_advice }

## Why a job with the timer has ended.

timer_no-answer_title = The timer did not answer.
timer_no-answer_advice = Press the switch of the timer briefly, hold the head closer than 20 cm, and try again. What you typed is kept.
timer_bad-reply_title = The answer of the timer cannot be right.
timer_bad-reply_advice = Try again. If it happens again: Settings, Expert, Line, “{ line_copyReport }”.
timer_unstable_title = The line is too noisy to trust.
timer_unstable_advice = Hold the infrared head closer, out of the sun, and try again.
timer_crowded_title = More than one timer may be in the beam.
timer_crowded_advice = Keep other timers and programmers away, and read again.
timer_other-memory_title = The current memory is not the one on the screen.
timer_other-memory_advice = Read again before you write.
timer_memory-unknown_title = This timer does not say which memory is current.
timer_memory-unknown_advice = So this page cannot look at another memory and go back. You can read and write the current one.
timer_memory-left_title = The memory that flies next may have changed.
timer_memory-left_advice = This page could not go back to the one that was current. Connect again and make the right memory fly next before you fly.
timer_other-timer_title = This is not the timer that answered before.
timer_other-timer_advice = The page reads it. Look at what it holds before you write.
timer_stale_title = The timer does not hold what was shown.
timer_stale_advice = Nothing was written. Look at what a write would change now.
timer_changed_title = The timer holds other values than before.
timer_changed_advice = Something else changed it, or this is another timer. Your changes are kept: look at the difference before you write.
timer_stood-still_title = This page stood still during the job.
timer_stood-still_advice = Nothing more was sent: another timer may be there by now. Read again.
timer_too-slow_title = This timer answers too slowly.
timer_too-slow_advice = Its answers take more than 3 seconds, so this page cannot tell which belongs to which question. Nothing more was sent. Try another adapter, or a cable in place of Bluetooth.
timer_undecided_title = { byteOrder_title }
timer_undecided_advice = { byteOrder_advice }
timer_serious_title = The checks have found something serious.
timer_serious_advice = { timer_stale_advice }
timer_busy_title = Something on this page or computer uses the adapter.
timer_busy_advice = Nothing was sent. Disconnect and connect again. What you typed is kept.
timer_port-lost_title = { link_lost_title }
timer_port-lost_advice = { link_lost_advice }
timer_aborted_title = Stopped.
timer_aborted_advice = Read again to see what the timer holds.
timer_closed_title = Disconnected.
timer_closed_advice = Press Connect to go on. What you typed is kept.

## Replies that are no noise, which is random.

alike_title = Each reply to { $request } is damaged in the same way.
alike_advice = That is not noise: the timer or its adapter forms these replies in a way that is not known. With Expert on in the settings, open Line and press “{ line_copyReport }”. Send the report to the maintainers (github.com/sidus-timer/sidus-timer/issues).
# What could be read although the rest could not.
alike_part = For looking only: { $values }. All else is not known.

## Messages that are not about errors.

notes_back_title = Your changes are back.
notes_back_advice = Compare them with what the timer holds, then write or undo them.
notes_back-uncertain_title = { notes_back_title }
notes_back-uncertain_advice = It is not known whether they were written. Connect to the timer and read it before you fly.
notes_moved_title = { timer_changed_title }
notes_moved_advice = { timer_changed_advice }
notes_timer-moved_title = { timer_changed_title }
notes_timer-moved_advice = { timer_changed_advice }
notes_kept_title = Your changes are kept on this device.
notes_kept_advice = They do not fit what was read now. They come back when you read that memory again; the start lists them, too.
notes_other-kind_title = Another kind of timer is there now.
notes_other-kind_advice = { timer_other-timer_advice }
notes_write-completed_title = The interrupted write is complete.
notes_write-completed_advice = The timer was read again and holds all that was to be written.
notes_nothing-written_title = { write_refused }
notes_nothing-written_advice = {""}
notes_not-backed-up_title = { write_unkept_title }
notes_not-backed-up_advice = { keeping_notKept }
notes_select-unanswered_title = The timer did not answer when a memory was selected.
notes_select-unanswered_advice = It answers other requests. Try again, or try it without a correct checksum.
notes_backed-up_title = All memories were read, and a backup of each is kept.
notes_backed-up_advice = {""}
notes_strays_title = { timer_crowded_title }
notes_strays_advice = { timer_crowded_advice }
notes_made-laid_title = The table shows your program, not what the timer holds.
notes_made-laid_advice = Nothing was written. What differs is marked. Undo shows what the timer holds.
notes_unexpected_title = Something went wrong in this page.
notes_unexpected_advice = Nothing more was sent. Load the page again. What you typed is kept.

## The flight of the program, and what the servos of the model move.

preview_title = Flight preview
preview_guessed = Not to scale.
preview_nameServos = Name the servos…
preview_play = Play
preview_speed = Speed
preview_time = Time of the flight
preview_launch = Launch
# $what: what has happened last, such as “Function 3, DT”.
preview_at = { $what } at { $time }
preview_sketch = The model from the side, and its rudder from above
preview_motor_true = Climb, motor runs
preview_motor_false = Glide, motor stopped
preview_flies = In flight
preview_comesDown = DT: the model comes down
preview_duties_rudder = Rudder
preview_duties_tailplane = Tailplane
preview_duties_wing = Wing
preview_duties_release = Disc or DT line
preview_duties_other = Something else
preview_duties_none = Not used
preview_naming_lead = What each servo moves, and between which steps. Up and down mean the trailing edge.
preview_naming_duty = { $servo } moves
preview_naming_name = Name for what { $servo } moves
preview_naming_low = { $servo }, one end in steps
preview_naming_high = { $servo }, other end in steps
preview_naming_from = from
preview_naming_to = to
preview_naming_sense = { $servo }, what more steps do
preview_naming_otherSense_false = more steps: up
preview_naming_otherSense_true = more steps: down
preview_naming_rudderSense_false = more steps: right
preview_naming_rudderSense_true = more steps: left

## The sheet of a program.

print_paper = Paper
print_what = On the sheet
print_parts_lines = Lines to write on
print_parts_code = QR code
print_nothing = Choose programs of the library, or open one.
print_choose = Programs on this print: { $chosen }
print_clear = Remove all
# The words on the paper.
print_simulated = simulated timer
print_warnings = Look at this before you fly
print_notes = Notes
print_codeHint = The camera of a phone opens this program, without its note.
print_unfinished =
    { $count ->
        [one] { $count } field has no value yet: the last one is printed
       *[other] { $count } fields have no value yet: the last one is printed
    }
print_printed = Printed { $date }

## The model in the strip.

# In the strip, in place of a model's name.
recognition_which = Which model?
# A button that shows the name of the model.
recognition_change = Model { $model }: say which model it is

## A memory with the pilot's name for it: M2 “fly-off”.

memoryNames_named = { $memory } “{ $name }”

## What an earlier job left behind on a timer.

recovery_title = An earlier write was interrupted.
recovery_when = A write into { $memory } began on { $time }.
recovery_nothing =
    { $missing ->
        [one] The timer holds what it held before: nothing was written, { $missing } change is missing.
       *[other] The timer holds what it held before: nothing was written, { $missing } changes are missing.
    }
# $values: such as “3 values”.
recovery_part =
    { $missing ->
        [one] The timer holds { $values } of that write; { $missing } value is still as before.
       *[other] The timer holds { $values } of that write; { $missing } values are still as before.
    }
recovery_foreign =
    { $count ->
        [one] { $count } value in the timer is neither old nor from that write. Is it another timer, or did something else change it?
       *[other] { $count } values in the timer are neither old nor from that write. Is it another timer, or did something else change it?
    }
recovery_sure = This page cannot tell timers of one kind apart. Go on only if this is the timer of that write.
recovery_finish = Finish the write…
recovery_goBack = Write the old values back…
recovery_leave = Leave it as it is
recovery_otherTimer = It is another timer
recovery_sameTimer = It is the same timer: show what was to be written
recovery_compare = Compare
recovery_before = Before
recovery_elsewhere = A write into { $memory } of a timer of this kind was interrupted. Read { $memory } to see what it holds.
recovery_left = Work on the memories was interrupted. Now { $current } flies next. Before that it was { $original }.
# By a note of this page alone: nobody has asked the timer since.
recovery_mayFly = { $memory } may fly next: selecting it was interrupted.
recovery_mayNotFly = Work on the memories was interrupted. Another memory than { $original } may fly next.
recovery_unknownMemory = an unknown memory

## The backups.

backups_title = Backups
backups_empty = Before each write, this page keeps here what the timer holds.
backups_reasons_write = before a write
backups_reasons_memories = all memories

## How the page looks.

theme_title = Colours
theme_names_system = System
theme_names_light = Light
theme_names_dark = Dark
theme_names_sun = Sun

## The settings of the page.

settings_look = Look
settings_expert = Expert: show the line
settings_expertHint = The line shows every byte between this page and the timer. The bench offers a jump that is not documented.
settings_kept = What this device keeps

## A saved program as a link and a QR code, and back.

share_offer_lead = The link holds the whole program. Nothing is sent to a server.
share_offer_link = Link
share_offer_copy = Copy link
share_offer_scan = Point the camera of the other device at this code, or send the link.
share_offer_qr = QR code of “{ $name }”
share_offer_cut = The end of the note does not fit in the QR code. The link holds the whole note.
share_offer_tooLong = Too long for a QR code. Send the link.
share_received_title = A program from a link
share_received_lead = So far this page only shows it. Nothing is kept, and nothing is written to a timer.
share_received_known = The library has these values already: { $name }.
share_received_modelChoice = Keep it under
share_received_newModel = New model “{ $name }”
share_received_keep = Keep in the library
share_received_discard = Do not keep
share_received_unwritten = What you have typed is kept: Undo, or the start, brings it back.
share_damaged_title = This link cannot be read.
share_damaged_bad = It is cut or damaged, or not from this page. Ask for it again.
share_paste_title = Paste a link…
share_paste_lead = The camera of a phone opens a QR code by itself. Here you can paste a link.
share_paste_show = Show
share_paste_notLink = This is not a link to a program.

## A DT for trimming that is about to be flown. The page asks before the pilot disconnects, and at a contest round.

shortDt_held = DT of { $memory } is { $dt }.
# Where the timer does not say which memory is current.
shortDt_heldHere = DT is { $dt }.
# $remembered: whether this memory held that DT before.
shortDt_ask =
    { $remembered ->
        [true] Put it back to { $back }?
       *[false] Set it to { $back }?
    }
shortDt_putBack =
    { $remembered ->
        [true] Put DT back to { $back }…
       *[false] Set DT to { $back }…
    }
shortDt_disconnect = Disconnect with { $memory }, DT{"\u00a0"}{ $dt }
# The memory is the one that was current when the pilot connected.
shortDt_disconnectHere = Disconnect with DT{"\u00a0"}{ $dt }
# Something that was typed prevents every write.
shortDt_blocked = Something that you typed cannot be written yet. Correct it before you put DT back.
shortDt_settings_limit = A DT is short below
shortDt_settings_hint = A shorter DT is red, and the page asks before you disconnect. With 0 s it never asks.

## The start, before anything was read.

start_title = Set your Sidus timer
start_lead = Read what it holds, change it, write it, and see it verified. Nothing leaves this device.
start_adapter = Plug in the adapter
start_firefox = Firefox asks for a permission first, and for the port each time this page is loaded.
# What a phone can connect to.
start_android = A phone connects over Bluetooth; a cable needs Android { firstVersions_androidCable } and Chrome { firstVersions_android }.
start_readyOffline = Ready offline
start_install = Install
start_picture_example = Example: an F1Q
start_picture_kept = Kept { $time }
start_models_title = My models
start_models_none = Keep the programs of each model, with notes.
start_models_programs =
    { $count ->
        [one] { $count } program
       *[other] { $count } programs
    }
start_models_library = Open the library
start_programs_title = Not finished
# A program that was made here.
start_programs_made = { $timer }, new
# Changes that are in no timer.
start_programs_changesOf = { $timer }, changes
start_programs_sure = Delete it for good?
start_simulatedTitle = No timer with you?
start_simulatedLead = A simulated one answers like a real one, byte for byte.
start_simulated = Try a simulated { $name } timer
start_backups =
    { $count ->
        [one] { $count } backup, kept before a write. The last: { $last }.
       *[other] { $count } backups, kept before a write. The last: { $last }.
    }

## The dialog that makes a program without a timer.

newProgram_title = New program…
newProgram_timerClass = Class
newProgram_functions = Functions, without start and DT
newProgram_servos = Servos
newProgram_from = Begin with
newProgram_beginnings_usual = Usual times, servos in the middle
newProgram_beginnings_nothing = All times and positions 0
newProgram_caution = The positions of your model are not known here. Set each of them before you write.
newProgram_make = Make the program

## The picture of a program over time.

timeline_title = Timeline
# While it is open whether the tried positions stay: what the timer held before them.
timeline_compareBefore = before following
timeline_picture = Servo positions over time
# $servos and $functions: such as “3 servos”.
timeline_description = { $servos } and { $functions } over time, DT at { $dt }. The table has all values.
timeline_descriptionMotor = { $servos } and { $functions } over time, DT at { $dt }, motor stop at { $motorStop }. The table has all values.
timeline_functions =
    { $count ->
        [one] { $count } function
       *[other] { $count } functions
    }
timeline_servos =
    { $count ->
        [one] { $count } servo
       *[other] { $count } servos
    }
timeline_keysToEdit = Arrows go from mark to mark and from servo to servo, plus and minus zoom, 0 shows all. Enter goes to the handles: arrows move them, Escape comes back.
timeline_ask = Point or tap to read
# While a handle is moved: the further away the pointer is, the finer.
timeline_finer = Finer
timeline_steps =
    { $position ->
        [one] { $position } step
       *[other] { $position } steps
    }
timeline_stepsUnit = steps
timeline_notKnown = Not known: the times fall
timeline_tools = View
timeline_zoomIn = Zoom in
timeline_zoomOut = Zoom out
timeline_fit = Show all
timeline_passedOver = { $slot } is skipped: { $next } comes at the same time.
timeline_goesBack = { $next } comes before { $slot }. It is not known what the timer does in the shaded part.

## A new version of the page.

update_ready = A new version is ready.
update_waits = It starts when you disconnect and nothing is open or unsaved.
update_take = Use it now
update_news = What is new

## The version of this page.

aboutPage_title = This page
aboutPage_version = Sidus Timer { $version }.
aboutPage_offline = The whole page is on this device: it works without a network.
aboutPage_notOffline = The page is not kept on this device yet: open it once with a network.
aboutPage_licences = Licences

## The views of the page and the links between them.

views_title = Views
views_names_program = Program
views_names_memories = Memories
views_names_bench = Bench
views_names_library = Library
views_names_line = Line
views_names_settings = Settings
views_names_print = Print
views_names_help = Help
views_print = Print…
views_share = Share…
views_noTimer_memories = Connect a timer to see its memories. Backups are below.
views_noTimer_bench = Connect a timer to move its servos.

## The strip above every view: the timer, its memory, DT, motor stop, and what is known.

strip_panel = Memories and more
# Positions that were tried while the servos follow: they are in the timer.
strip_tried =
    { $count ->
       *[other] { $count } tried
    }
strip_notCertain = not certain
strip_asRead = last read
# In place of a figure.
strip_notValid = not valid
# For a program of the library.
strip_ofSetting =
    { $changes ->
        [0] saved
       *[other] { $changes } not saved
    }
# For a program that was made here and is in no timer.
strip_made = in no timer

## The list of commands.

palette_title = Commands
palette_search = Type what you want to do
palette_nothing = No command has this name, or it cannot be done now.
# As the key is marked: “Strg” in German.
palette_ctrl = Ctrl+{ $key }

## In place of a part of the page that is being loaded.

parts_coming = Loading
parts_failed = A part of this page could not be loaded.
parts_again = Try again

## Which model it is.

# $when: a day, or a time of today.
whichModel_recognition_same = This is { $model }, as seen { $when }.
whichModel_recognition_like =
    { $count ->
        [one] This is like { $model }, { $count } value differs. Is it { $model }?
       *[other] This is like { $model }, { $count } values differ. Is it { $model }?
    }
# $models: a choice, such as “Lancer, Vega or 3 more”.
whichModel_recognition_several = This may be { $models }. Which model is it?
# A choice of models: “Lancer, Vega or 3 more”.
whichModel_or = { $names } or { $last }
whichModel_others =
    { $count ->
       *[other] { $count } more
    }
whichModel_recognition_unknown = This timer is not known here. Which model is it?
whichModel_recognition_yes = Yes, { $model }
whichModel_recognition_choose = Choose…
whichModel_recognition_ok = OK
whichModel_recognition_dialog_title = Which model is it?
whichModel_recognition_dialog_lead = A timer does not know its model. The page compares what it holds with what it last saw in each model.
whichModel_recognition_dialog_said = You have said that it is { $model }.
whichModel_recognition_dialog_moreMemories = Read the other memories, too: they may tell the models apart.
whichModel_recognition_dialog_none = No such model of this class.
whichModel_recognition_dialog_newModel = A new model
whichModel_recognition_dialog_keep = Keep as a new model
whichModel_memoryNames_label = Name of { $memory }
whichModel_memoryNames_give = Name
# $to: the models to which the timer may belong.
whichModel_crossing_title = These are values of { $from }, but this timer looks like that of { $to }.
whichModel_crossing_advice = With the values of another model you can lose this one. Look at the model in front of you.
whichModel_crossing_confirm = Write values of { $from } into the timer of { $to }.
# $memory: with its name.
whichModel_crossing_memoryOf = { $memory } of { $model }

## A write, from the difference to the verdict.

write_title = Write to the timer
write_lead = This is what changes in { $memory }. Everything else stays as it is.
# Names the choice of a memory.
write_target = Write to
write_nothing = Nothing differs. The timer is read back and compared.
write_field = Value
write_from = Timer holds
write_to = Will hold
write_wasRead = Was read
write_moved_model_title = This timer seems to belong to another model now.
write_moved_model_advice = Nothing was written. Look at the names of the models.
write_moved_edits_title = The program has changed since this was shown.
write_unkept_title = This device could not keep a backup of what the timer holds now.
write_unkept_advice = This memory is still as it was. Go on without a backup?
# The name of a table of values, made from its columns.
write_sideBySide = Values: { $names }
write_withoutCopy = Go on without a backup
write_safety = The propeller is off or the model is held, and the timer is not armed.
write_acknowledge = I have read this and want to write it anyway.
write_stillToTick = Still to tick: { $ticks }.
write_ticks_model = other model
write_ticks_warnings = warnings
write_ticks_safety = propeller
write_move_why = This timer seems to keep positions only where its servos stand. If the servos do not move, it will probably not keep these.
write_move_label = Move the servos to each function before its positions are stored.
write_move_hint = Hold the model safely, with nothing in their way.
write_move_notHeld_title = The timer acknowledged the positions but did not keep them.
write_move_notHeld_advice = This timer probably keeps them only where its servos stand. Write again, and let the servos move to each function.
write_move_again = Write again…
write_start =
    { $count ->
        [0] Read back and compare
        [one] Write { $count } change
       *[other] Write { $count } changes
    }
write_stages_read = Reading
write_stages_write = Writing
write_stages_verify = Reading back
write_stages_repair = Correcting
write_stopping = Stopping after this request
# A job that has selected another memory. Disconnect ends it at once.
write_stoppingBack = Stopping: first back to the memory from before
write_verified_title = Verified.
write_verified_advice = The timer was read back and holds what was shown.
write_verdict = { $memory } verified { $time }
write_asItIs = as it is
write_insteadOf = instead of { $value }
write_wanted = To be written
write_readBack = Read back
write_differs_title = The timer did not take every value.
write_differs_advice = The timer was read back. It holds other values here:
write_unknown_title = It is not certain what the timer holds.
write_unknown_advice = The timer could not be read back completely. Read again, then write what still differs. Your changes are kept.
# Once a reading has shown what became of it.
write_cut = The write into { $memory } was interrupted.
write_strayed_title = { $memory } became current during the write.
write_strayed_advice = Some of the values may be in { $memory } now. Read it, and look at all of it before you fly it.
write_refused = Nothing was written.
write_status_differs = differs
write_status_unknown = not known
write_putBack = changed by itself, put back

## What the parts of the page that are loaded first say.

name = Sidus Timer
classNames_Q = F1Q
classNames_B = F1B
classNames_E = F1E
unknownClass = Class { $letter }
# $number: counted from 1.
memoryName = M{ $number }
# $number: counted from 1.
servoName = S{ $number }
slotName =
    { $kind ->
        [start] Start
        [dt] DT
       *[function] Function { $slot }
    }
# Inside a sentence.
within_slot =
    { $kind ->
        [start] start
        [dt] DT
       *[function] function { $slot }
    }
within_idleThrottle = idle throttle
# Where there is little room: only the number.
slotShort =
    { $kind ->
        [start] Start
        [dt] DT
       *[function] { $slot }
    }
# Before a sentence about something.
about = { $name }:
previous = Previous
next = Next
pause = Pause
# The key for less of something, for a screen reader.
less = { $what }: less
moreOf = { $what }: more
# A space in quotes may break: these stand where there is little room.
seconds = { $time }{" "}s
# “2 min 30 s”, “3 min”, “20 s”.
times_minutes = { $minutes }{" "}min
times_minutesSeconds = { $minutes }{" "}min { $seconds }{" "}s
times_units_s = s
times_units_min = min
# “10.0 s”, “3:00 min”.
times_figure = { $text } { $unit }
# A time that was typed as seconds and is a minute or more: “230 s, 3:50”.
times_asSeconds = { $seconds }{" "}s, { $clock }
# The label of the two answers.
times_meaning = What { $field } means
header_firmware = firmware { $firmware }
header_simulated = simulated
header_connect = Connect
header_choosePort = Choose another adapter
header_closeProgram = Close program
header_disconnect = Disconnect
header_stop = Stop
program_tableCaption = Time and servo positions of each function
program_slot = Function
program_time = Time
program_memory = Memory
program_memoryUnknown = This timer does not say which memory is current, so it is not known which one flies next.
program_memoryOpen = It is not known which memory flies next. Make one fly next, or read again.
program_dt = DT
program_motorStop = Motor stop
# Where there is little room.
program_motor = Motor
program_idleThrottle = Idle throttle
program_throttle = Idle
program_idleThrottleUnit = unit unknown
program_reserved = reserved { $time }
program_timeOf = { $slot } time
program_motorStopTime = Motor stop time
program_positionOf = { $slot }, { $servo }
program_shortDt = Short DT
program_changes =
    { $count ->
        [one] { $count } change
       *[other] { $count } changes
    }
program_undoAll = Undo all
program_read = Read again
program_connectAndWrite = Connect and write…
# $count: of the values that differ.
program_write =
    { $count ->
        [0] Write…
        [one] Write { $count } change…
       *[other] Write { $count } changes…
    }
program_picture = Picture
program_table = Table
# What prevents a write. Its button goes there.
program_blocked = Nothing can be written yet. { $field }: { $why }
program_findings = Checks
program_noFindings = Nothing unusual.
program_absolute = Shown from launch. It is not known whether this timer counts from launch or from the function before.
program_severity_error = Cannot be written
program_severity_serious = Serious
program_severity_warning = Unusual
program_reading = Reading the timer
program_selecting = Changing the memory
otherTab_holdsSince = Sidus Timer is open in another tab, since { $since }.
# Until that tab has said it.
otherTab_holds = Sidus Timer is open in another tab.
otherTab_takeOver = Use it here
otherTab_busy = The other tab is working with the timer. It opens here as soon as that has ended.
otherTab_gone = The other tab does not answer. Close it, then load this page again.
# While requests of a job are repeated. A timer that fell asleep looks like a bad line: both are named.
disturbed = Answers are missing or damaged: is the timer awake, and the infrared head close, out of the sun? This ends in { $seconds } s at the latest.
cancel = Cancel
close = Close
copy = Copy
copied = Copied.
copyByHand = The browser does not let this page copy. Copy it from here.
dismiss = Dismiss
done = Done
undo = Undo
open = Open
save = Save
delete = Delete
notNow = Not now
label_language = Language
label_name = Name
label_note = Note
label_model = Model
label_search = Search
noModel = No model
# After the first of a list.
more =
    { $count ->
       *[other] And { $count } more.
    }
showMore =
    { $count ->
       *[other] Show { $count } more
    }
# A button of a row, for a screen reader, which does not know the row.
of = { $button }: { $name }
notFitting = It does not fit the connected timer. Disconnect to open it.
notKept = This browser has not kept it: it is lost when this page is closed.

## The walk through the open questions of docs/protocol.md with a real timer.

settle_title = Settle it with your timer
settle_lead = Not all is known about how these timers talk. In fifteen minutes yours settles what is open. Each value that is tried is put back. Have the handheld programmer at hand.
settle_safe = The propeller is off or the motor is disconnected, and the timer is not armed.
settle_danger = Something may move now. Is the propeller off, or the motor disconnected? Look once more.
settle_blocked = First settle what the band above says, and keep or put back what was tried.
settle_readIt = Read the timer
settle_which = Which does the handheld show?
settle_tryHint = Move the servos and wait until they stand still. Then try a position: it is changed and put back within seconds. Watch the servos.
settle_tryIt = Try a position
settle_moved = The old position is back: it was read. Did a servo move when the new one was tried?
settle_ask = Ask with four zeros
settle_unknown = I do not know
settle_send = Send the file with this form
# What is settled: most are sentences that are true or not.
settle_names_order = The low byte of a time comes first
settle_names_unit = Times are in hundredths of a second
settle_names_count = Times count from launch
settle_names_memories = The first memory has the number 0
settle_names_zeros = Four zeros are enough
settle_names_layout = The function comes before the servo
settle_names_stores = Positions are kept at any function
settle_names_moves = A written position moves its servo
settle_names_unlock = Letter that answers UNLOCK
settle_names_delay = Usual time of an answer
settle_names_reserved = Reserved time as read
settle_yes = Yes
settle_no = No
settle_unnumbered = No number is given
settle_there = Only where the servos stand
settle_delay = { $ms } ms
settle_open = Not settled
