### Deutsch: alles, was die Seite sagt. Die Vorlage ist en.ftl.
###
### Translated without a pilot of that language; corrections welcome (docs/translating.md).

## Moving servos and motor from the page.

bench_slots = Stellen auf
bench_elsewhere = Servos und Motor arbeiten mit { $memory }, dem Speicher für den nächsten Flug. Zeigen Sie { $memory }, um sie zu bewegen.
bench_trim = Trimmen bei { $slot }
bench_at = Servos stehen bei { $slot }
bench_atNone = Es ist nicht bekannt, wo die Servos stehen.
bench_moveMaybe = Es kam keine Antwort. Die Servos können sich trotzdem bewegt haben. Sehen Sie das Modell an.
bench_unlocked = Der Motor ist entsperrt. Der Propeller kann anlaufen.
bench_unlockMaybe = Es kam keine Antwort. Der Motor kann trotzdem entsperrt sein. Bleiben Sie weg vom Propeller.
bench_jumped = Der Timer hat den Sprung bestätigt.
bench_here = Servos hier
bench_waits = Wartet auf „Schreiben“.
bench_bring = Servos auf { $slot } stellen
bench_follow = Servos folgen den Stellungen
bench_followHint = Zuerst liest die Seite den Timer und legt eine Sicherung an. Danach wird jede Stellung, die Sie in der Zeile ändern, bei der die Servos stehen, sofort in den Timer geschrieben, und ihr Servo bewegt sich.
bench_followingNow = Servos folgen: Eine Stellung, die Sie in der Zeile ändern, bei der die Servos stehen, wird sofort in den Timer geschrieben.
bench_stopFollowing = Folgen beenden
bench_ended_over = Die Servos folgen nicht mehr.
bench_ended_memory = Die Servos folgen nicht mehr: Ein anderer Speicher ist aktuell oder könnte es sein.
bench_ended_strayed = Während die Servos folgten, wurde ein anderer Speicher aktuell. Er kann einige der Stellungen übernommen haben: Sehen Sie ihn ganz durch, bevor Sie damit fliegen.
bench_ended_unlike = Die Servos folgen nicht mehr: Der Timer hat nicht getan, was er bestätigt hat.
bench_ended_failed = Die Servos folgen nicht mehr: Der Timer hat nicht geantwortet.
bench_notTaken = { $field }: Im Timer steht { $held }, nicht { $wanted }.
bench_beside =
    { $more ->
        [0] Außerdem geändert: { $named }.
        [one] Außerdem geändert: { $named } und { $more } weiterer Wert.
       *[other] Außerdem geändert: { $named } und { $more } weitere Werte.
    }
bench_triedHere =
    { $more ->
        [0] Probiert: { $named }.
        [one] Probiert: { $named } und { $more } weitere Stellung.
       *[other] Probiert: { $named } und { $more } weitere Stellungen.
    }
bench_triedAndWaiting =
    { $waiting ->
        [0] { $tried } im Timer probiert
        [one] { $tried } im Timer probiert, { $waiting } wartet auf „Schreiben“
       *[other] { $tried } im Timer probiert, { $waiting } warten auf „Schreiben“
    }
bench_triedIn = { $memory }: Es wurden Stellungen probiert.
bench_decide = Das Probierte behalten oder zurücksetzen auf das, was der Timer vorher enthielt?
bench_keep = Behalten
bench_putBack = Zurücksetzen…
bench_unlock = Halten für UNLOCK
bench_unlockHold = Weiter halten
bench_unlockHint = Der Propeller kann anlaufen. Halten Sie das Modell fest und die Hände weg vom Propeller. Drücken Sie dann die Taste und halten Sie sie gedrückt.
bench_experimental = Experimentell
bench_jumpHint = Springt zur Funktion, die auf ein vorzeitiges Auslösen von DT folgt. Die genaue Wirkung ist nicht dokumentiert: Servos können sich bewegen.
bench_jump = Sprung…
bench_jumpSure = Sprung jetzt senden

## The log of flights.

flights_title = Flüge
flights_empty_title = Noch kein Flug eingetragen.
flights_empty_advice = Lesen oder schreiben Sie einen Timer und drücken Sie dann „{ flights_flying_button }“.
flights_failed = Der Browser kann die Bibliothek gerade nicht lesen. Schließen Sie andere Tabs dieser Seite und versuchen Sie es noch einmal.
flights_flying_button = Flug eintragen
flights_flying_purpose = Trägt einen Flug ein, mit dem, was der Timer enthält.
flights_flying_logged = Flug eingetragen { $time }
flights_flying_fillIn = Ausfüllen
flights_flying_again = Nochmals eintragen
flights_row_round = Durchgang { $round }
flights_row_wind = { $wind } m/s
flights_row_temperature = { $degrees } °C
flights_row_noResult = kein Ergebnis
flights_row_changed = { $values } geändert
flights_row_otherTimer = anderer Timer
flights_totals_flights =
    { $count ->
        [one] { $count } Flug
       *[other] { $count } Flüge
    }
flights_totals_best = bester { $time }
flights_totals_average = Mittel { $time }
flights_filter_of = Flüge: { $name }
flights_filter_clear = Alle zeigen
flights_form_title = Flug
flights_form_result = Ergebnis
flights_form_resultHint = Sekunden, oder Minuten wie 2:58.
flights_form_readAs = { $time }, { $seconds } s
flights_form_propose = Eintragen: { $facts }
flights_form_full = Voller Durchgang, 180 s
flights_form_round = Durchgang
flights_form_flyOff = Stechen
flights_form_wind = Wind
flights_form_windUnit = m/s
flights_form_temperature = Temperatur
flights_form_temperatureUnit = °C
flights_form_when = Datum, Ort, Modell
flights_form_date = Datum und Zeit
flights_form_noOffset = Die Zeitzone des Geländes ist nicht bekannt: Das ist die Zeit dieses Geräts.
flights_form_place = Ort
flights_form_flown = Was geflogen wurde
flights_form_open = Sein Programm öffnen
flights_form_unreadable_not-a-number = Keine Zahl.
flights_form_unreadable_not-a-time = Keine Zeit: Geben Sie Sekunden wie 178 oder Minuten wie 2:58 ein.
flights_form_unreadable_too-fine = { unreadable_too-fine }
flights_form_range = { $min } bis { $max } { $unit }.
flights_form_shortDt = DT war bei diesem Flug { $dt }.
flights_score_open = Wertungskarte
flights_score_maximum = Maximum je Durchgang
flights_score_none = Ohne Maximum zählt jedes Ergebnis voll.
flights_score_maximumOf = Maximum für { $round }
flights_score_counted = Gewertet (s)
flights_score_notCounted = nicht gewertet
flights_score_count = Diesen werten
flights_score_noRound = kein Durchgang
flights_score_total = Summe
flights_score_copy = Als Text kopieren
flights_csv_save = Als Tabelle speichern (CSV)
flights_csv_columns_date = Datum
flights_csv_columns_time = Zeit
flights_csv_columns_zone = Zeitzone
flights_csv_columns_place = Ort
flights_csv_columns_model = Modell
flights_csv_columns_setting = Programm
flights_csv_columns_timerClass = Klasse des Timers
flights_csv_columns_memory = Speicher
flights_csv_columns_dt = DT (s)
flights_csv_columns_motorStop = Motorstopp (s)
flights_csv_columns_wind = Wind (m/s)
flights_csv_columns_temperature = Temperatur (°C)
flights_csv_columns_round = Durchgang
flights_csv_columns_result = Ergebnis (s)
flights_csv_columns_maximum = Maximum (s)
flights_csv_columns_note = Notiz
flights_section_all = Alle seine Flüge

## Values that are unusual, or cannot be written.

findings_time-not-whole = { unreadable_not-a-whole-number }
findings_time-out-of-range = Möglich ist { $min } bis { $max }.
findings_position-not-whole = { unreadable_not-a-whole-number }
findings_position-out-of-range = Möglich ist { $min } bis { $max }.
findings_throttle-not-whole = { unreadable_not-a-whole-number }
findings_throttle-out-of-range = Möglich ist { $min } bis { $max }.
findings_position-as-read = Gelesen als { $value }, über dem letzten Schritt { $max }. Der Wert bleibt, solange Sie ihn nicht ändern.
findings_time-falls = Das kommt früher als die Funktion darüber ({ $previous }).
findings_time-repeats = Dieselbe Zeit wie die Funktion darüber, { $previous }.
findings_position-never-reached = Dieselbe Zeit wie die Funktion darüber, { $previous }. Die Stellungen der Funktion darüber werden nie erreicht.
findings_motor-stop-after-dt = Der Motor stoppt erst nach DT ({ $dt }): Das Modell kommt mit laufendem Motor herunter.
findings_motor-run-long = Der Motor läuft länger als { $limit }, die Grenze für F1Q.
findings_time-outside-manual = Die Anleitung erlaubt { $min } bis { $max }.
findings_time-too-fine = Die Anleitung nennt Stufen von { $step }: Der Timer kann runden.
findings_dt-short = Kürzer als { $limit }.
findings_dt-moves-nothing = Bei DT bewegt sich kein Servo: Der Timer holt das Modell nicht herunter.
findings_throttle-unusual = Mehr als { $limit } ist unüblich. Die Einheit ist nicht bekannt.
findings_class-unknown = Die Klasse „{ $timerClass }“ ist nicht bekannt: Ihre Regeln wurden nicht geprüft.

## Why a text in a field is no value.

unreadable_empty = Leer: Geben Sie einen Wert ein.
unreadable_not-a-time = Keine Zeit: Geben Sie Sekunden wie 12,5 oder Minuten wie 2:05 ein.
unreadable_too-fine = Feiner als eine Hundertstelsekunde.
unreadable_not-a-whole-number = Es muss eine ganze Zahl sein.
unreadable_ambiguous = Das kann man verschieden lesen: Wählen Sie eine Lesart.

## For a page that cannot reach a timer here.

restWorks = Alles außer der Verbindung geht auch hier.

## What an Android phone needs.

firstVersions_android = 148
firstVersions_androidBluetooth = 138
firstVersions_lastBluetoothOnly = 147
firstVersions_androidCable = 17
android = Chrome { firstVersions_android } oder neuer ({ firstVersions_androidBluetooth } bis { firstVersions_lastBluetoothOnly } nur über Bluetooth); ein Kabel braucht Android { firstVersions_androidCable }

## For every browser about which nothing more is known. docs/connection.md names the first versions.

unsupportedHere_title = Dieser Browser erreicht keinen Timer.
unsupportedHere_advice = Nehmen Sie am Computer ein aktuelles Chrome, Edge, Opera oder Firefox, am Telefon Chrome auf Android. { restWorks }

## Replaces the sentence above where the browser's name tells more.

unsupported_brave_title = Brave erreicht einen Timer nur, wenn Sie es erlauben.
unsupported_brave_advice = Öffnen Sie brave://flags/#brave-web-serial-api, stellen Sie es auf Enabled und drücken Sie Relaunch. { restWorks }
unsupported_ios_title = Auf einem iPhone oder iPad erreicht kein Browser einen Timer.
unsupported_ios_advice = Nehmen Sie einen Computer oder Chrome auf einem Android-Telefon. { restWorks }
unsupported_android_title = { unsupportedHere_title }
unsupported_android_advice = Auf Android geht es mit { android }. { restWorks }

## What a saved program held before it was saved over.

versions_title = Frühere Fassungen
versions_until = Bis{"\u00a0"}{ $when }
versions_changed =
    { $more ->
        [0] dann { $change }
       *[other] dann { $change } und noch{"\u00a0"}{ $more }
    }
versions_otherLayout = dann Werte für einen anderen Timer
versions_same = Das gespeicherte Programm enthält jetzt dasselbe.
versions_goBack = Zu dieser zurückkehren

## Two programs side by side.

compare_title = Vergleich
compare_open = Vergleichen…
compare_second = mit
compare_screen = Auf dem Bildschirm
compare_timer = Timer, { $memory }
compare_groups_now = Jetzt
compare_groups_settings = Gespeicherte Programme
compare_setting = { $model } · { $name }
compare_backup = { $memory } · { $when }
compare_backupOf = { $model } · { $memory } · { $when }
compare_nothing = Auf diesem Gerät ist kein anderes Programm dieser Klasse und dieses Aufbaus.
compare_take = Holen
compare_takeOf = { $value } für { $field } holen
compare_takeHint = „Holen“ kopiert einen Wert in das Programm auf dem Bildschirm.

## How a backup differs from what its timer holds.

modelBackups_same = wie im Timer { $when }
modelBackups_differs =
    { $count ->
        [one] { $count } Wert anders als im Timer { $when }
       *[other] { $count } Werte anders als im Timer { $when }
    }
modelBackups_now = jetzt

## Undo, redo, and edits of many fields at once.

edits_redoButton = Wiederholen
edits_undo = Rückgängig: { $step }
edits_redo = Wiederholen: { $step }
edits_steps_change = { $what } geändert
edits_steps_shift = { $what } verschoben um { $by }
edits_steps_step-servo = { $what } um { $steps }
edits_steps_step-servo-from = { $what } um { $steps }, ab { $from }
edits_steps_paste = { $count } eingefügt
edits_steps_fill = { $count } nach unten ausgefüllt
edits_steps_revert-all = alles zurückgesetzt
edits_steps_open = { $what } geöffnet
edits_steps_keep-tried = Probiertes behalten
edits_opened = „{ $name }“
edits_openedUnnamed = anderes Programm
edits_refused_start = Der Start hat keine Zeit, die man ändern kann.
edits_refused_later-out-of-range = Eine spätere Funktion läge außerhalb von { $min } bis { $max }.
edits_refused_unreadable = Ein Text, der kein Wert ist, steht im Weg. Berichtigen Sie ihn zuerst.
edits_refused_interval-disagrees = Dieser Abstand passt nicht zu den Zeiten der beiden Zeilen.
edits_refused_no-place = Diese Stelle hat das Programm nicht.
edits_refused_twice = Diese Stelle kommt zweimal vor, mit verschiedenen Werten.
edits_refused_too-large = Die Tabelle ist zu groß: Höchstens { $cells } Zellen werden gelesen. Der Rest wurde weggelassen.
edits_beforeLaunch = Das läge vor dem Start.
edits_nothingDone = Nichts wurde geändert.
edits_cells =
    { $count ->
        [one] { $count } Wert
       *[other] { $count } Werte
    }
edits_change = { $field }: { $from } → { $to }
edits_field_putBack = { $field } zurücksetzen
edits_field_putBackTo = { $field } auf { $figure } zurücksetzen
edits_sheet_title = Tasten für { $field }
edits_sheet_erase = Letzte Ziffer löschen
edits_sheet_putBack = Zurücksetzen
edits_sheet_selectRange = Bereich wählen
edits_sheet_goTo = Weiter zu { $name }
edits_table_explain = Was die Werte bedeuten
edits_table_interval = Abstand
edits_table_countedFrom = ab { $row }
edits_table_switch = Zeit oder Abstand
edits_table_intervalOf = { $slot }, Abstand
edits_table_range_title = Gewählter Bereich
edits_table_range_pick = Tippen Sie jetzt auf eine andere Zelle.
edits_table_range_size = { $cells }, { $columns }
edits_table_range_functions =
    { $count ->
        [one] { $count } Funktion
       *[other] { $count } Funktionen
    }
edits_table_range_rows =
    { $count ->
        [one] { $count } Zeile
       *[other] { $count } Zeilen
    }
edits_table_range_columns =
    { $count ->
        [one] { $count } Spalte
       *[other] { $count } Spalten
    }
edits_table_range_paste = Einfügen…
edits_table_range_fillDown = Unten ausfüllen
edits_table_range_clipboardClosed = Diese Seite sieht nichts, was sie einfügen kann. Tippen Sie auf das erste Feld und fügen Sie dort ein.
edits_table_tools = Werkzeuge für { $name }
edits_stepServo_title = Alle Stellungen von { $servo }
edits_stepServo_now = Jetzt { $position }
edits_stepServo_nowRange = Jetzt { $lowest } bis { $highest }
edits_stepServo_by = Um (Schritte)
edits_stepServo_step = Verstellen
edits_stepServo_which = Welche
edits_stepServo_all = Alle Funktionen
edits_stepServo_from = Ab { $slot }
edits_stepServo_stops =
    { $count ->
        [one] { $steps }: { $what } endet bei { $at }.
       *[other] { $steps }: { $what } enden bei { $at }.
    }
edits_shift_open = Verschieben…
edits_shift_from =
    { $isLast ->
        [true] { $row }
       *[false] { $row } und alles danach
    }
edits_shift_by = Um (Sekunden)
edits_shift_earlier = Früher
edits_shift_later = Später
edits_shift_moveDt = DT mitverschieben
edits_shift_function = Funktion { $number }
edits_shift_functionRange = Funktionen { $first } bis { $last }
edits_shift_functions = Funktionen { $numbers }
edits_shift_moved =
    { $later ->
        [true] { $time }{" "}s später
       *[false] { $time }{" "}s früher
    }
edits_pasting_asks = Diese Namen sind nicht bekannt. Wählen Sie, was sie bedeuten:
edits_pasting_choose = Wählen
edits_pasting_leaveOut = Weglassen
edits_pasting_table = Was wohin kommt
edits_pasting_lead =
    { $count ->
        [0] Das ändert nichts.
        [one] Das ändert { $count } Wert.
       *[other] Das ändert { $count } Werte.
    }
edits_pasting_reading = { $field }: „{ $text }“ wird als { $time } gelesen.
edits_pasting_problems = Das lässt sich nicht einfügen:
edits_pasting_place = Zeile { $row }, Spalte { $column } des kopierten Texts
edits_pasting_problem = { $place }: { $reason }
edits_pasting_problemOf = { $place }, „{ $text }“: { $reason }
edits_pasting_apply = Einfügen
edits_presets_title = DT-Vorwahl
edits_presets_use = DT { $time }
edits_presets_refused = Geben Sie Zeiten wie 20 s oder 2:30 ein, bis 10:55 min, höchstens 24.
edits_fix = Auf { $value } setzen
edits_fixOf = Auf { $value } setzen: { $field }

## The library as files: export, import, and the reminder to export.

files_export_all = Alles exportieren…
files_export_one = Exportieren…
files_export_downloaded = „{ $name }“ geht in Ihre Downloads: { $what }. Sehen Sie nach, ob die Datei dort ist.
files_export_without = ohne { $kind }
files_export_kinds_models = Modelle
files_export_kinds_settings = Programme
files_export_kinds_flights = Flüge
files_export_partly = „{ $name }“ ist nicht vollständig. Die Datei enthält { $what }. Was der Browser gerade nicht lesen kann: { $missing }. Schließen Sie andere Tabs dieser Seite und exportieren Sie noch einmal.
files_export_and = { $first } und { $next }
files_export_tooLarge = Die Bibliothek ist zu groß für eine Datei. Exportieren Sie ihre Modelle einzeln.
files_export_failed = Die Datei konnte nicht erstellt werden. Laden Sie die Seite neu und versuchen Sie es noch einmal.
files_import_button = Importieren…
files_import_title = { $name } importieren
files_import_lead = Gespeichert { $date }. Enthält { $what }.
files_import_leadNothing = Gespeichert { $date }. Enthält nichts.
files_import_ignored =
    { $count ->
        [one] { $count } Eintrag stammt von einer neueren Version dieser Seite und wird weggelassen.
       *[other] { $count } Einträge stammen von einer neueren Version dieser Seite und werden weggelassen.
    }
files_import_nothing = Das alles haben Sie schon.
files_import_differs = Was sich unterscheidet
files_import_ways_newer = Das Neuere nehmen
files_import_ways_both = Beides behalten
files_import_itself = das Modell selbst
files_import_flightOf = Flug: { $day }
files_import_wayText_newer = Was hier neuer ist oder dasselbe Datum hat, bleibt.
files_import_wayText_both = Beides bleibt. Was aus der Datei kommt, bekommt eine Nummer hinter den Namen.
files_import_unknownModel = Ein Modell, das hier fehlt
files_import_group_fresh = Neu: { $what }
files_import_group_same = Gleich: { $what }
files_import_group_fileNewer = In der Datei neuer: { $what }
files_import_group_deviceNewer = In der Datei nicht neuer: { $what }
files_import_group_fileName = { $file } (hier: { $here })
files_import_take =
    { $count ->
        [0] Nichts zu importieren
       *[other] { $count } importieren
    }
files_import_allStays = Nichts in der Datei ist neuer. Wählen Sie „{ files_import_ways_both }“, um es trotzdem zu importieren.
files_import_done = Aus „{ $name }“ importiert: { $what }.
files_import_undo = Import rückgängig
files_import_undone = Der Import ist rückgängig gemacht. Spätere Änderungen bleiben.
files_refused_title = { $name } lässt sich nicht importieren
files_refused_nothing = Nichts wurde importiert.
files_refused_again = Exportieren Sie die Datei noch einmal oder bitten Sie den Absender um eine neue.
files_refused_fault = Zeile{"\u00a0"}{ $line }: gefunden { $found }.
files_refused_faultIn = Zeile{"\u00a0"}{ $line }, { $place }: gefunden { $found }.
files_refused_wanted = Erwartet:
files_refused_place_entry =
    { $kind ->
        [models] Modell „{ $name }“
        [settings] Programm „{ $name }“
       *[flights] Flug „{ $name }“
    }
files_refused_place_unnamed =
    { $kind ->
        [models] Modell { $number } in der Datei
        [settings] Programm { $number } in der Datei
       *[flights] Flug { $number } in der Datei
    }
files_refused_place_function = Funktion { $number }
files_refused_damaged = Die Datei ist beschädigt oder nicht vollständig.
files_refused_files_too-large = Die Datei ist zu groß für eine Bibliothek.
files_refused_files_gone = Die Datei konnte nicht gelesen werden. Wählen Sie sie noch einmal.
files_refused_files_several = Importieren Sie eine Datei nach der anderen.
files_refused_format = Das ist keine Bibliotheksdatei von Sidus Timer.
files_refused_newer = Eine neuere Version dieser Seite hat sie erstellt. Laden Sie die Seite neu, wenn Sie online sind.
files_reminder =
    { $changes ->
        [one] { $changes } Änderung der Bibliothek ist nur auf diesem Gerät. Geht es verloren, bringt nur eine Datei sie zurück.
       *[other] { $changes } Änderungen der Bibliothek sind nur auf diesem Gerät. Geht es verloren, bringt nur eine Datei sie zurück.
    }

## For the time before the other sentences are loaded.

first_failed = Die Seite ist nicht vollständig. Haben Sie Netz?
first_again = Neu laden

## What a system shows of the installed page: public/manifest.webmanifest has the same in English.

manifest_description = Stellt Sidus-Timer für den Freiflug ein, F1Q, F1B und F1E: liest, was ein Timer enthält, nimmt Ihre Änderungen, schreibt sie, liest sie zurück und vergleicht. Bewahrt Ihre Modelle und Programme auf diesem Gerät auf. Geht ohne Netz.
manifest_connect = Einen Timer verbinden
manifest_connectShort = Verbinden
manifest_connectWhat = Die Startseite, mit „Verbinden“ zur Hand
manifest_library = Bibliothek
manifest_libraryWhat = Modelle und ihre Programme
manifest_simulated = Simulierter Timer
manifest_simulatedWhat = Die Startseite, mit den simulierten Timern zur Hand
manifest_pictures_program = Das Programm eines Timers, zwei Änderungen markiert
manifest_pictures_write = Was das Schreiben ändern wird, bevor es geschieht
manifest_pictures_programPhone = Das ganze Programm auf einem Telefon
manifest_pictures_writePhone = Was das Schreiben ändern wird, auf einem Telefon

## The help inside the page.

guide_pages_checklist = Checkliste
guide_pages_trouble = Probleme
guide_pages_words = Werte
guide_pages_steps = Erste Schritte
guide_nav = Hilfeseiten

## What a new pilot is told.

firstSteps_1 = Lesen: „Verbinden“ drücken, den Timer wecken, den Infrarotkopf nahe halten. Lesen ändert nichts und bewegt nichts.
firstSteps_2 = Schreiben: neue Werte eingeben, „Schreiben“ drücken, jeden Unterschied ansehen. „Verifiziert“ heißt: Der Timer wurde noch einmal gelesen und enthält, was Sie wollen.
firstSteps_3 = Fliegen: Oben auf der Seite steht, welcher Speicher für den nächsten Flug gilt, und seine DT-Zeit. Die Seite braucht kein Netz, und nichts verlässt dieses Gerät.

## The values of a program, with unit and range.

values_function_text = Ein Abschnitt des Flugs: Zu seiner Zeit geht jedes Servo in seine Stellung. Um eine Funktion zu überspringen, geben Sie ihr die Stellungen der Funktion davor.
values_function_range = Meist Start, neun Funktionen und DT.
values_time_text = Wann eine Funktion beginnt, gezählt ab dem Start. Geben Sie 12,5 oder 2:05 ein. Bei F1B und F1E ist nicht bekannt, ab wann der Timer zählt.
values_time_range = Nach den Anleitungen. F1Q: 0,1 bis 99,9 s. F1B: 0,01 bis 9,99 s für die Funktionen 1 und 2, danach 0,1 bis 99,9 s. F1E: nicht bekannt.
values_after_text = Die Zeit seit der Funktion davor. Alle späteren Funktionen verschieben sich mit, DT nicht.
values_position_name = Stellung
values_position_text = Wo ein Servo steht. Der Winkel eines Schritts hängt von Servo und Anlenkung ab: Probieren Sie es auf dem Prüfstand.
values_position_range = 0 bis 130 Schritte.
values_motorStop_text = F1Q: wann der Motor stoppt, gezählt ab dem Start. Kein Servo bewegt sich dabei.
values_motorStop_range = Nach der Anleitung 0,1 bis 99,9 s, in Stufen von 0,1 s.
values_dt_text = Die Thermikbremse: wann sie das Modell herunterholt, gezählt ab dem Start. Rot, wenn kürzer als Ihre Grenze.
values_dt_range = Nach der Anleitung 1 bis 720 s. Mehr als 10:55 min lässt sich nicht senden.
values_idleThrottle_text = F1Q: wahrscheinlich, wie schnell der Motor dreht, solange der Startschalter gedrückt ist.
values_idleThrottle_range = Die Seite nimmt 0 bis 100 an. Die Einheit ist nicht bekannt.
values_memory_text = Ein Timer hat mehrere Speicher mit je einem Programm. Der gewählte gilt für den nächsten Flug. Um einen anderen anzusehen, wählt die Seite ihn und kehrt zurück. Wird das unterbrochen, sagt sie, welcher vielleicht für den nächsten Flug gilt.
values_memory_range = Meist vier, M1 bis M4. Ältere Timer haben fünf.

## What a pilot checks before a flight.

checklist_lead = Haken Sie jeden Punkt ab. Die Haken gelten für einen Flug und werden nicht aufbewahrt.
checklist_items_memory = Der richtige Speicher ist für den nächsten Flug gewählt.
checklist_items_dtTime = Ich habe die DT-Zeit laut gesagt.
checklist_items_surfaces = Flügel, Höhenleitwerk und Seitenruder sitzen fest und stehen, wie sie sollen.
checklist_items_battery = Der Akku ist geladen, sein Stecker sitzt ganz drin.
checklist_items_dtSeen = Ich habe gesehen, wie das Servo in die DT-Stellung geht.
checklist_items_radioDt = Ich habe die Funkauslösung von DT probiert, falls es eine gibt.
checklist_items_switch = Ich habe den Startschalter fünfmal gedrückt, und er ist jedes Mal zurückgesprungen.
checklist_items_propeller = Der Propeller sitzt fest und dreht sich frei. Niemand steht vor ihm.
checklist_known_now = Nächster Flug: { $memory }, DT{"\u00a0"}{ $dt }, gelesen { $time }.
checklist_known_onceAt = Wie zuletzt gelesen, { $time }: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_once = Wie zuletzt gelesen: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_not = Es ist nicht bekannt, was { $memory } enthält. Lesen Sie diesen Speicher, bevor Sie fliegen.
checklist_known_nothing = Kein Timer wurde gelesen. Verbinden Sie einen, um hier den Speicher für den nächsten Flug und dessen DT-Zeit zu sehen.
checklist_known_unwritten =
    { $count ->
        [one] { $count } Änderung noch nicht im Timer.
       *[other] { $count } Änderungen noch nicht im Timer.
    }
checklist_left =
    { $count ->
        [one] noch { $count } Punkt
       *[other] noch { $count } Punkte
    }
checklist_done = Alles abgehakt. Guten Flug.
checklist_again = Alle Haken löschen

## Problems as a pilot sees them, and what to do.

troubles_symptoms_noAnswer_title = Der Timer antwortet nicht
troubles_symptoms_noAdapter_title = Die Seite findet den Adapter nicht
troubles_symptoms_refused_title = Der Adapter lässt sich nicht öffnen
troubles_symptoms_wrongValues_title = Die Werte sehen falsch aus
troubles_symptoms_wrongValues_steps_1 = Sehen Sie oben auf der Seite nach: Welcher Speicher ist zu sehen, und welcher gilt für den nächsten Flug?
troubles_symptoms_wrongValues_steps_2 = Drücken Sie „{ program_read }“.
troubles_symptoms_wrongValues_steps_3 = Nehmen die Zeiten von Zeile zu Zeile ab? Dann fragt die Seite, wie sie zu lesen sind.
troubles_symptoms_wrongValues_steps_4 = Vergleichen Sie bei F1B und F1E die Zeiten mit dem Programmiergerät.
troubles_symptoms_cutOff_title = Das Schreiben wurde unterbrochen
troubles_symptoms_cutOff_steps_1 = Fliegen Sie dieses Modell noch nicht. Verbinden Sie den Timer: Die Seite liest ihn und bietet dann an, zu Ende zu schreiben oder die alten Werte zurückzuschreiben.
troubles_symptoms_cutOff_steps_2 = Was der Timer vorher enthielt, steht unter „Speicher“, „Sicherungen“.
troubles_symptoms_noDt_title = DT löst nicht aus oder zur falschen Zeit
troubles_symptoms_noDt_steps_1 = Sehen Sie oben auf der Seite nach: Dort steht, welcher Speicher für den nächsten Flug gilt, und seine DT-Zeit. Ein anderer Speicher hat eine andere DT-Zeit.
troubles_symptoms_noDt_steps_2 = Springt der Startschalter jedes Mal zurück? Solange er gedrückt ist, beginnt der Ablauf nicht, und DT löst nicht aus.
troubles_symptoms_noDt_steps_3 = Ist der Akku geladen, und sitzt sein Stecker ganz drin? Wenn der Timer nicht läuft, löst DT nicht aus.
troubles_symptoms_noDt_steps_4 = Halten Sie das Modell sicher fest und drücken Sie in der Ansicht „{ views_names_bench }“ auf die Zeile DT. Geht das Servo in die DT-Stellung, und gibt es frei, was es hält?
troubles_symptoms_noDt_steps_5 = Nehmen Sie den Propeller ab und lassen Sie den Timer bis zum Ende laufen. Fliegen Sie nicht, bevor Sie gesehen haben, dass sich das Servo zur DT-Zeit bewegt.
troubles_symptoms_noMove_title = Ein Servo bewegt sich nicht
troubles_symptoms_noMove_steps_1 = Halten Sie das Modell fest und drücken Sie in der Ansicht „{ views_names_bench }“ auf die Zeile der Funktion, bei der sich das Servo bewegen soll. Nichts bewegt sich? Prüfen Sie Stecker und Akku. Dort bewegt es sich, aber nicht im Flug? Dann hat es dieselbe Stellung wie in der Funktion davor.
troubles_symptoms_noMove_steps_2 = Geht es woandershin, als die Tabelle sagt? Manche Timer behalten eine Stellung vielleicht nur für die Funktion, bei der die Servos stehen. Die Seite bietet dann an, die Servos beim Schreiben zu bewegen.
troubles_symptoms_noMove_steps_3 = Brummt es, oder bleibt es zu früh stehen? Vielleicht blockiert die Anlenkung: Versuchen Sie einen kleineren Weg.
troubles_symptoms_noMotor_title = Der Motor läuft nicht an
troubles_symptoms_noMotor_steps_1 = Nach einem Flug sperrt der Timer den Motor. Um ihn zu entsperren, halten Sie das Modell fest und die Hände weg vom Propeller: Er kann anlaufen. Halten Sie dann in der Ansicht „{ views_names_bench }“ die Taste „{ bench_unlock }“ gedrückt.
troubles_symptoms_noMotor_steps_2 = Ist der Startschalter zurückgesprungen? Solange er gedrückt ist, läuft der Motor nur im Leerlauf.
troubles_symptoms_noMotor_steps_3 = Ist der Motorstopp spät genug? Bei 0,1 s stoppt der Motor, sobald er angelaufen ist.
troubles_symptoms_noLibrary_title = Meine Modelle und Programme sind nicht da
troubles_symptoms_noLibrary_steps_1 = Leeren Sie das Suchfeld, drücken Sie „Archiv“.
troubles_symptoms_noLibrary_steps_2 = Jeder Browser, jedes Profil und jede Adresse hat eine eigene Bibliothek; ein privates Fenster löscht sie.
troubles_symptoms_noLibrary_steps_3 = Auf einem anderen Gerät, oder wenn sie verloren ist: „Importieren“ und die Datei Ihres letzten Exports.

## What to do, step by step, when a timer cannot be reached.

help_title = Was tun
help_steps_programs = Schließen Sie andere Tabs und Programme, die den Adapter benutzen, etwa Arduino IDE, PuTTY, ein Programm für 3D-Drucker oder einen Drohnen-Konfigurator.
help_steps_replug = Ziehen Sie den Adapter ab, warten Sie fünf Sekunden, stecken Sie ihn wieder an. Hilft das nicht, starten Sie den Computer neu.
help_steps_cable = Stecken Sie den Adapter direkt an, ohne Hub, und versuchen Sie ein anderes Kabel. Viele USB-Kabel laden nur.
help_steps_windows = Windows: Öffnen Sie den Geräte-Manager. Ein gelbes Zeichen am Adapter heißt, dass sein Treiber fehlt: Gehen Sie ins Internet und starten Sie Windows Update.
help_steps_mac = Mac: Erlauben Sie das Zubehör, wenn der Mac fragt. Ein altes macOS braucht den Treiber des Herstellers.
help_steps_linux = Linux lässt Sie den Adapter vielleicht nicht benutzen. Führen Sie das aus, dann melden Sie sich ab und wieder an.
help_steps_linux-container = Vielleicht hat das Linux eines Chromebooks den Adapter. Schalten Sie ihn dort ab: Einstellungen, Linux-Entwicklungsumgebung, USB-Geräte verwalten.
help_steps_android = Auf Android geht es mit { android }. { restWorks }
help_steps_bluetooth = Bluetooth: Koppeln Sie den Adapter in den Einstellungen des Systems (Code 1234 oder 0000), lassen Sie ihn eingeschaltet und in der Nähe, und schalten Sie Bluetooth an anderen Geräten aus, die ihn benutzen.
help_steps_firefox-finds = Firefox findet keine Bluetooth-Adapter und überhaupt keine, wenn es aus dem Ubuntu Store kommt. Nehmen Sie Chrome.
help_steps_firefox-reload = Firefox hält einen Adapter fest, der versagt hat. Laden Sie diese Seite neu. Was Sie eingegeben haben, bleibt.
help_steps_switch = { link_stages_steps_switch }
help_steps_near = { link_stages_steps_near }
help_steps_battery = Ist der Akku des Timers geladen und angesteckt? Bei leerem Akku steht ein Timer in seiner DT-Stellung.
help_steps_restarts = Manche Adapter starten neu, wenn ihr Port geöffnet wird (DTR setzt sie zurück), und hören einige Sekunden lang nichts. Ist das bei Ihrem so, stellen Sie seine Baudrate unter „Optionen“, „{ ports_settings }“ ein: Dann wird der Port nur einmal geöffnet. Die Seite selbst lässt DTR, wie der Browser es setzt.
help_steps_usual-settings = Öffnen Sie „Optionen“, „{ ports_settings }“ und drücken Sie „{ ports_reset }“: Dann findet die Seite die Baudrate von selbst.
help_steps_report = Wenn es wieder vorkommt: „Optionen“, „Experte“, „Leitung“, „{ line_copyReport }“. Senden Sie den Bericht an:
help_steps_address = Öffnen Sie diese Adresse in einem Tab:
help_page = Alle Anleitungen, für jedes System

## For when the browser does not store, or give back, what it should.

keeping_title = Dieser Browser bewahrt nicht alles auf.
keeping_notKept = Was Sie eingeben, Sicherungen und der Vermerk über einen unterbrochenen Schreibvorgang bleiben nur, solange diese Seite offen ist. Exportieren Sie die Bibliothek. Schließen Sie dann andere Tabs dieser Seite, oder schaffen Sie Platz auf diesem Gerät.
keeping_notKnown = Der Browser sagt nicht, ob er aufbewahrt, was Sie tun. Rechnen Sie damit, dass er es nicht tut, und exportieren Sie die Bibliothek.
keeping_oneTab = Benutzen Sie nur einen Tab dieser Seite.
keeping_emptied = Der Browser hat gelöscht, was er für diese Seite aufbewahrt hat. Exportieren Sie, was Sie noch sehen.
keeping_export = Bibliothek exportieren…

## Stored data that cannot be read.

aside_title =
    { $count ->
        [one] 1 Datensatz war nicht lesbar. Er ist beiseitegelegt, nicht gelöscht.
       *[other] { $count } Datensätze waren nicht lesbar. Sie sind beiseitegelegt, nicht gelöscht.
    }
aside_write = Darunter ist der Vermerk über einen unterbrochenen Schreibvorgang: Lesen Sie den Timer, bevor Sie fliegen.
aside_save = In eine Datei speichern

## “2 models, 1 program”: only kinds that there are.

counted_models =
    { $count ->
        [one] { $count }{"\u00a0"}Modell
       *[other] { $count }{"\u00a0"}Modelle
    }
counted_settings =
    { $count ->
        [one] { $count }{"\u00a0"}Programm
       *[other] { $count }{"\u00a0"}Programme
    }
counted_flights =
    { $count ->
        [one] { $count }{"\u00a0"}Flug
       *[other] { $count }{"\u00a0"}Flüge
    }
counted_backups =
    { $count ->
        [one] { $count }{"\u00a0"}Sicherung
       *[other] { $count }{"\u00a0"}Sicherungen
    }

## What was deleted a moment ago.

removed = Gelöscht: { $what }.

## Deletes everything that this device keeps.

erase_open = Alles auf diesem Gerät löschen…
erase_lead = Das löscht alle Modelle, Programme, Flüge, Sicherungen, ungeschriebenen Änderungen und Optionen dieser Seite aus diesem Browser. Es lässt sich nicht rückgängig machen. Timer behalten, was sie enthalten.
erase_uncertain = Ein Schreibvorgang wurde unterbrochen, und es ist nicht bekannt, was jener Timer enthält. Ohne den Vermerk darüber kann diese Seite Sie nicht warnen: Lesen Sie jenen Timer, bevor Sie fliegen.
erase_start = Alles löschen
erase_running = Löscht
erase_failed = Nicht alles konnte gelöscht werden. Schließen Sie andere Tabs dieser Seite und versuchen Sie es noch einmal, oder löschen Sie ihre Daten in den Einstellungen des Browsers.

## For a page that is shown inside another page.

framed_title = Sidus Timer arbeitet nur in einem eigenen Tab: Eine andere Seite könnte verdecken, was Sie von Ihrem Timer sehen.
framed_open = Sidus Timer in einem eigenen Tab öffnen

## What is known about the content of a timer, and what is not.

knowledge_title = Ungewiss
knowledge_uncertain = Es ist nicht bekannt, was { $memory } enthält: { $values }.
knowledge_noFly = Fliegen Sie nicht, bevor er gelesen ist.
knowledge_since = Unterbrochener Schreibvorgang, begonnen { $time }.
knowledge_thisMemory = der aktuelle Speicher
knowledge_memoryOf = { $memory } ({ $timer })
knowledge_timer_here = { $name } { $firmware }
knowledge_timer_simulated = simulierter { $name } { $firmware }
knowledge_otherTimer_here = anderer { $name } { $firmware }
knowledge_otherTimer_simulated = anderer simulierter { $name } { $firmware }
knowledge_motorStop = Motorstopp
knowledge_either = { $name } ist { $before } oder { $goal }
knowledge_list =
    { $more ->
        [one] { $named }, und { $more }{"\u00a0"}weiterer{"\u00a0"}Wert ist ungewiss
       *[other] { $named }, und { $more }{"\u00a0"}weitere{"\u00a0"}Werte sind ungewiss
    }
knowledge_and = { $first } und { $next }
knowledge_connect = Verbinden und lesen
knowledge_forget = Das vergessen…
knowledge_forgetSure = Vergessen Sie es nur, wenn Sie jenen Timer anderswo gelesen haben oder ihn nicht mehr haben.
knowledge_forgetNow = Jetzt vergessen
knowledge_verified = Wie im Timer, verifiziert { $time }
knowledge_readAt = Wie im Timer, gelesen { $time }
knowledge_lastReadAt = Wie zuletzt gelesen, { $time }
knowledge_lastRead = Wie zuletzt gelesen
knowledge_ofSetting =
    { $changes ->
        [0] { $name }: gespeichert
        [one] { $name }: { $changes } Änderung nicht gespeichert
       *[other] { $name }: { $changes } Änderungen nicht gespeichert
    }
knowledge_changed = { $name }, geändert
knowledge_ofModel = { $name } von { $model }
knowledge_made = Neues Programm, noch in keinem Timer
knowledge_unknown = Nicht bekannt, was { $memory } enthält
knowledge_unfinished =
    { $count ->
        [one] { $count } Feld hat noch keinen Wert
       *[other] { $count } Felder haben noch keinen Wert
    }
knowledge_hints_now = Markierte Felder weichen von dem ab, was der Timer enthält.
knowledge_hints_onceAt = Markierte Felder weichen von dem ab, was zuletzt gelesen wurde, { $time }.
knowledge_hints_once = Markierte Felder weichen von dem ab, was zuletzt gelesen wurde.
knowledge_marks_now = war { $value }
knowledge_marks_once = zuletzt gelesen { $value }
knowledge_notCertain = , jetzt ungewiss
knowledge_held_now = Timer enthält
knowledge_held_once = Zuletzt gelesen

## Why a program of the library or from a link cannot be opened now.

obstacles_busy = Diese Seite liest, schreibt oder sucht einen Timer. Warten Sie, bis sie fertig ist.
obstacles_following = Die Servos folgen. Beenden Sie das zuerst.
obstacles_not-fitting = { notFitting }

## Models and their saved programs.

library_unread = Der Browser kann die Bibliothek gerade nicht lesen. Schließen Sie andere Tabs dieser Seite und versuchen Sie es noch einmal.
library_empty_title = Noch kein Modell
library_empty_lead = Ein Modell enthält seine Programme, mit Namen und Notizen. Sie bleiben nur auf diesem Gerät.
library_empty_hint = Legen Sie ein Modell an, oder lesen Sie einen Timer und speichern Sie sein Programm.
library_search_label = Programme suchen
library_search_nothing = Kein Programm hat alle diese Wörter.
library_models_title = Modelle
library_models_all = Alle Modelle
library_models_make = Neues Modell…
library_models_settings =
    { $count ->
        [one] { $count } Programm
       *[other] { $count } Programme
    }
library_models_archive = Archiv ({ $count })
library_models_archived = im Archiv
library_models_latest = Zuletzt geändert
library_list_open = auf dem Bildschirm
library_model_timerClass = Klasse
library_model_noClass = Keine Angabe
library_model_facts = Über dieses Modell
library_model_noSettings = Noch kein Programm.
library_model_servos = Servos
library_model_servosUnknown = Speichern Sie zuerst ein Programm dieses Modells.
library_model_servoWay = { $low } bis { $high } Schritte
library_model_archive = Archivieren
library_model_unarchive = Aus dem Archiv holen
library_model_remove = Modell löschen
library_model_withSettings =
    { $count ->
        [one] Sein Programm wird mit gelöscht. „Rückgängig“ bringt beides zurück.
       *[other] Seine { $count }{"\u00a0"}Programme werden mit gelöscht. „Rückgängig“ bringt alles zurück.
    }
library_setting_isOpen = Auf dem Bildschirm: ansehen
library_setting_loadAgain =
    { $count ->
        [one] Neu öffnen: { $count } Wert geht zurück
       *[other] Neu öffnen: { $count } Werte gehen zurück
    }
library_setting_tags = Stichwörter, durch Kommas getrennt
library_setting_from_typed = eingegeben
library_setting_from_timer = aus einem Timer gelesen
library_setting_from_simulated = aus einem simulierten Timer gelesen
library_setting_from_backup = aus einer Sicherung
library_setting_from_file = aus einer Datei
library_setting_from_link = aus einem Link
library_setting_origin = { $source }, { $time }
library_setting_notShown = Es konnte nicht geöffnet werden. Versuchen Sie es noch einmal.
library_setting_gone = Es ist nicht mehr in der Bibliothek.
library_save_open = Speichern…
library_save_over = { $program } überschreiben
library_save_undo = Speichern von { $name } zurücknehmen
library_save_crossing = Das sind Werte von { $from }. Unter { $to } speichern.
library_save_asNew = Als neu speichern…
library_save_taken = Es gibt schon ein Programm { $program }. Geben Sie einen anderen Namen ein, oder:
library_save_replace = Überschreiben. Seine Werte bleiben als frühere Fassung.
library_save_name =
    { $of ->
        [program] Name des Programms
       *[model] Name des Modells
    }
library_save_namePlace = Zum Beispiel: Stechen, ruhig
library_save_notSavable = Ein Feld hat keinen Wert. Berichtigen Sie es zuerst.
library_save_state =
    { $changes ->
        [0] { $name }: gespeichert
        [one] { $name }: { $changes } Änderung nicht gespeichert
       *[other] { $name }: { $changes } Änderungen nicht gespeichert
    }
library_nameNeeded = Es braucht einen Namen.

## The log of the line.

line_empty = Nichts zu zeigen.
line_unused = Noch nichts auf der Leitung. Sie können auch eine Aufzeichnung laden und als Timer abspielen.
line_all = Alles
line_out = Zum Timer
line_in = Vom Timer
line_damaged = Beschädigt
line_request = { $name } · { $letters }
line_reply = { $name }, Antwort · { $letters }
line_echo = { $name }, Echo · { $letters }
line_unknown = Unbekannter Buchstabe { $letter }
line_names_GETTIMERS = Zeiten lesen
line_names_SETTIMERS = Zeiten schreiben
line_names_GETSERVOPOS = Stellungen lesen
line_names_SETSERVO = Stellung schreiben
line_names_MOVETOFUNC = Servos bewegen
line_names_GETSWVER = Erkennen
line_names_UNLOCK = Motor entsperren
line_names_JUMP2 = Sprung
line_names_GETMEMORY = Welcher Speicher
line_names_SETMEMORY = Speicher wählen
line_names_GETLOWRPM = Leerlauf lesen
line_names_SETLOWRPM = Leerlauf schreiben
line_rejected_noise = Beschädigt: Rauschen
line_rejected_length = Beschädigt: unmögliche Länge
line_rejected_terminator = Beschädigt: kein Ende, wo es sein sollte
line_rejected_checksum = Beschädigt: falsche Prüfsumme
line_rejected_silence = Beschädigt: abgeschnitten
line_error_framing = Leitungsfehler: Rahmen
line_error_parity = Leitungsfehler: Parität
line_error_break = Leitungsfehler: Break
line_error_overrun = Leitungsfehler: Überlauf, Bytes gingen verloren
line_error_other = Leitungsfehler anderer Art
line_position = { $slot }, { $servo }: { $steps } Schritte
line_motorStop = Motorstopp { $time }
line_reserved = reserviert { $time }
line_functions = Funktionen { $times }
line_identity = { $name }, Firmware { $firmware }, { $functions } und DT, { $memories }, { $servos }
line_memories =
    { $count ->
        [one] { $count } Speicher
       *[other] { $count } Speicher
    }
line_memoryUnsaid = Er sagt nicht, welcher.
line_idleThrottle = { $value }, Einheit unbekannt
line_idleThrottleUnsaid = Er gibt keinen Wert an.
line_acknowledged = Bestätigt.
line_unreadable_wrong-length = Der Inhalt ist länger oder kürzer, als er sein sollte.
line_unreadable_unknown-command = Es ist nicht bekannt, was es bedeutet.
line_unreadable_unexpected-reply = Es antwortet auf eine andere Anfrage.
line_unreadable_bad-identity = Was es über den Timer sagt, kann nicht stimmen.
line_unreadable_identity-needed = Lesbar, sobald der Timer gesagt hat, was er ist.
line_unreadable_out-of-range = Ein Wert darin kann nicht stimmen.
line_unreadable_not-an-integer = { line_unreadable_out-of-range }
line_unreadable_wrong-count = { line_unreadable_out-of-range }
line_unreadable_wrong-type = { line_unreadable_out-of-range }
line_unreadable_unknown-word = Der Inhalt ist nicht lesbar.
line_unreadable_bad-capture = { line_unreadable_unknown-word }
line_unreadable_bad-file = { line_unreadable_unknown-word }
line_unreadable_bad-link = { line_unreadable_unknown-word }
line_unreadable_newer-version = { line_unreadable_unknown-word }
line_unreadable_too-large = { line_unreadable_unknown-word }
line_unreadable_duplicate = { line_unreadable_unknown-word }
line_goOn = Weiter
line_came =
    { $number ->
        [one] Angehalten. Seither { $number } Eintrag.
       *[other] Angehalten. Seither { $number } Einträge.
    }
line_clear = Leeren
line_unidentified = unbekannt
line_load = Laden…
line_filter = Zeigen
line_searchHint = Name oder Hex
line_counts_out = { $count } zum Timer
line_counts_in = { $count } vom Timer
line_counts_damaged = { $count } beschädigt
line_counts_errors =
    { $count ->
        [one] { $count } Leitungsfehler
       *[other] { $count } Leitungsfehler
    }
line_recording =
    { $entries ->
        [one] { $name }: eine Aufzeichnung mit { $entries } Eintrag.
       *[other] { $name }: eine Aufzeichnung mit { $entries } Einträgen.
    }
line_replay = Als Timer abspielen
line_cannotReplay = Sie lässt sich nicht abspielen: Der Timer sagt nie, was er ist.
line_back = Zurück zur laufenden Leitung
line_noRecordingAt = Zeile { $line }: erwartet werden eine Zeit in Sekunden, > oder < und Bytes in Hex.
line_noRecording = Diese Datei ist keine Aufzeichnung.
line_send_title = Ein Telegramm von Hand senden
line_send_lead = Länge und Prüfsumme fügt die Seite hinzu.
line_send_bytes = Buchstabe und Daten, in Hex
line_send_faults_hex = Geben Sie für jedes Byte zwei Hexziffern ein, 0 bis 9 oder A bis F.
line_send_faults_too-long = Ein Telegramm fasst höchstens 252 Bytes.
line_send_preview = Geht hinaus als
line_send_send = Senden…
line_send_confirmTitle = Dieses Telegramm an den Timer senden?
line_send_danger = Servos können sich bewegen, der Propeller kann anlaufen, und was der Timer enthält, kann sich ändern. Danach wird der Timer neu gelesen.
line_send_confirm = Ja, einmal senden
line_send_sending = Sendet
line_send_answered = Antwort:
line_send_unanswered = Es kam keine Antwort. Was das Telegramm verlangt, kann trotzdem geschehen sein.
line_copyReport = Bericht kopieren

## From the ports to a timer that answers.

link_portNames_ftdi = FTDI-Adapter
link_portNames_cp210x = CP210x-Adapter (Silicon Labs)
link_portNames_ch340 = CH340-Adapter (WCH)
link_portNames_pl2303 = PL2303-Adapter (Prolific)
link_portNames_bluetooth = Bluetooth
link_portNames_usb = USB-Adapter
link_portNames_other = Serieller Port
link_stages_choosing = Wählen Sie den Adapter des Timers
link_stages_openingLong_title = Der Adapter braucht lange zum Öffnen
link_stages_openingLong_advice = Bluetooth: Adapter einschalten, in der Nähe. Kabel: abziehen und wieder anstecken.
link_stages_asking = Fragt mit { $rate } Baud.
link_stages_noAnswer = Seit { $seconds } s keine Antwort. Die Seite fragt weiter und macht von selbst weiter.
link_stages_open = Der Adapter ist offen
link_stages_steps_switch = Wecken Sie den Timer: Drücken Sie kurz seinen Schalter
link_stages_steps_near = Halten Sie den Infrarotkopf näher als 20 cm, nicht in der Sonne
link_stages_steps_other = Hängt der Timer an einem anderen Adapter?
link_refused = Die Seite versucht es noch 15 Sekunden. Vielleicht hat ein anderes Programm den Adapter.
link_heard_title = Etwas ist zu hören, aber kein Timer antwortet.
link_heard_advice = Wecken Sie den Timer und halten Sie den Infrarotkopf näher, nicht in der Sonne, oder wählen Sie einen anderen Adapter.
link_slow_title = Ein Timer antwortet, aber zu langsam.
link_slow_advice = Seine Bytes kommen einzeln mit { $rate } Baud, mit so langen Lücken, dass keine Antwort rechtzeitig ganz da ist. Diese Seite kann ihn nicht lesen. Versuchen Sie einen anderen Adapter oder ein Kabel statt Bluetooth.
link_itSaid = Was kam: { $bytes } („{ $text }“).
link_trySelectBare = Ohne korrekte Prüfsumme versuchen
link_lost_title = Die Verbindung zum Adapter ist verloren.
link_lost_advice = Stecken Sie ihn an oder bringen Sie ihn in die Nähe: Die Seite macht von selbst weiter. Was Sie eingegeben haben, bleibt.
link_status_off = Nicht verbunden
link_status_opening = Verbindet
link_status_searching = Sucht den Timer
link_status_away = Verbindung verloren
link_status_closing = Trennt

## The known ports, and how they are opened.

ports_title = Bekannte Adapter
ports_forget = Vergessen
ports_settings = Serielle Einstellungen
ports_settingsHint = Nur für besondere Adapter. Die Seite findet die Baudrate von selbst.
ports_rate = Baudrate
ports_findRate = Suchen
ports_baud = { $rate } Baud
ports_parity = Parität
ports_parities_none = Keine
ports_parities_even = Gerade
ports_parities_odd = Ungerade
ports_stopBits = Stoppbits
ports_dtr = DTR
ports_rts = RTS
ports_signals_leave = Wie vom Browser gesetzt
ports_signals_on = Ein
ports_signals_off = Aus
ports_reset = Übliche Einstellungen

## What is known about the connected timer. Its numbers are in the report.

aboutTimer_title = Über diesen Timer
aboutTimer_damage = Schäden auf der Leitung
aboutTimer_crowd = Vielleicht ist ein anderer Timer oder ein Programmiergerät im Strahl. Seither müssen zwei Lesungen übereinstimmen.
aboutTimer_found = Was er anders gemacht hat
aboutTimer_nothingFound = Bisher nichts: Er hat alles wie üblich ausgeführt.
aboutTimer_quirkNames_timers-reply-66 = Er antwortet mit dem Buchstaben eines anderen Befehls.
aboutTimer_quirkNames_unlock-reply-6a = { aboutTimer_quirkNames_timers-reply-66 }
aboutTimer_quirkNames_memory-unknown = Er sagt nicht, welcher Speicher aktuell ist.
aboutTimer_quirkNames_memory-impossible = { aboutTimer_quirkNames_memory-unknown }
aboutTimer_quirkNames_bare-checksum = Er antwortet zum Leerlauf nicht wie üblich.
aboutTimer_quirkNames_times-big-endian = Seine Zeiten nehmen ab. Mit je zwei vertauschten Bytes würden sie zunehmen.
aboutTimer_quirkNames_servo-first = Beim Schreiben einer Stellung nimmt er das Servo vor der Funktion.
aboutTimer_quirkNames_servo-unanswered = Er hat beim Schreiben einer Stellung nicht geantwortet.
aboutTimer_quirkNames_times-rounded = Er rundet Zeiten.
aboutTimer_quirkNames_memories-from-one = Er zählt seine Speicher ab 1.
aboutTimer_quirkNames_positions-unchanged = Er hat Stellungen bestätigt, aber nicht behalten.
aboutTimer_quirkNames_echo = Der Adapter sendet zurück, was man ihm sendet.
aboutTimer_quirkNames_idle-throttle-unanswered = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_identity-unusual = Was er von sich sagt, enthält Bytes, die nicht bekannt sind.
aboutTimer_quirkNames_idle-throttle-malformed = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_replies-alike = Seine Antworten auf manche Anfragen sind beschädigt, jede auf dieselbe Art.
aboutTimer_assumed = Bekannte Abweichungen
aboutTimer_assumedHint = Gemerkt für diesen Adapter und diese Art von Timer.
aboutTimer_forget = Bekannte Abweichungen vergessen
aboutTimer_assumptions_bigEndianTimes = Die zwei Bytes jeder Zeit sind vertauscht
aboutTimer_assumptions_servoFirst = { aboutTimer_quirkNames_servo-first }
aboutTimer_assumptions_memoriesFromOne = { aboutTimer_quirkNames_memories-from-one }
aboutTimer_assumptions_bareChecksumRequests = „{ line_names_SETMEMORY }“ und „{ line_names_SETLOWRPM }“ werden ohne korrekte Prüfsumme gesendet
aboutTimer_assumptions_positionsNeedMove = Stellungen bleiben nur bei der Funktion, bei der die Servos stehen

## Which memory flies next, and what is known about the others.

nextFlight_badge = nächster Flug
nextFlight_onScreen = Das ist { $memory }.
nextFlight_named = { $memory }, nächster Flug
nextFlight_other = Nächster Flug: { $memory }.
nextFlight_last = { $memory } war aktuell, als der Timer zuletzt geantwortet hat. Dieser Speicher gilt für den nächsten Flug, sofern nichts anderes das geändert hat.
nextFlight_original = Beim Verbinden war es { $original }.
nextFlight_originalUnknown = Es ist nicht bekannt, welcher es beim Verbinden war.
nextFlight_unknown = Es ist nicht bekannt, welcher Speicher für den nächsten Flug gilt.
nextFlight_asked = { $memory } wurde zuletzt gewählt.
nextFlight_back = Zurück zu { $original }
nextFlight_leaving_title = Bevor Sie trennen
nextFlight_leaving_back = Zurück zu { $original } und trennen
nextFlight_leaving_failed = Der Timer ist nicht zu { $original } zurückgekehrt. Er ist noch verbunden.

## The last reading of a memory that is not current.

look_read = { $memory }, gelesen { $time }
look_notRead = { $memory } wurde nicht gelesen
look_either = Entweder
look_or = oder
look_lead = Nur zum Ansehen. Nächster Flug: { $current }.
look_edit = { $memory } bearbeiten
look_look = { $memory } ansehen
look_hint = Das wählt { $memory }, liest ihn und kehrt zu { $current } zurück.
look_fly = { $memory } für den Flug wählen
look_show = { $memory } zeigen

## Jobs over several memories, and the backups.

memories_copy = { $from } nach { $to } kopieren
memories_restore = Sicherung zurückspielen
memories_restoreAll = Alle { $count } zurückspielen…
memories_plans_screen =
    { $keepsThrottle ->
        [true] { $to } wird die Zeiten und Stellungen auf dem Bildschirm enthalten. Was { $to } jetzt enthält, wird zuerst gesichert. Der Leerlauf bleibt, wie er ist.
       *[false] { $to } wird die Zeiten und Stellungen auf dem Bildschirm enthalten. Was { $to } jetzt enthält, wird zuerst gesichert.
    }
memories_plans_copy = { $to } wird die Zeiten und Stellungen von { $from } enthalten, wie eben gelesen. Was { $to } jetzt enthält, wird zuerst gesichert.
memories_plans_restore = Das schreibt die Sicherung ({ $time }) in: { $names }. Was jetzt dort ist, wird zuerst gesichert.
memories_atEnd = Am Ende gilt für den nächsten Flug wieder { $current }.
memories_refused = { $memory }: Hier lässt sich nichts schreiben. Keine Software kann diese Werte senden.
memories_untouched = { $memory }: Nichts wurde geschrieben.
memories_stopped = Was noch nicht geschrieben war, ist, wie es war.

## All memories of a timer at a glance.

overview_readAll = Alle lesen und sichern
overview_copyTo = Kopieren nach…
overview_compareWith = Mit { $memory } vergleichen
overview_readAt = gelesen { $time }
overview_notCertain = Ungewiss: Hier wurde ein Schreibvorgang unterbrochen. Gezeigt wie vor diesem Schreibvorgang.
overview_edited = Gezeigt und kopiert wird, was der Timer enthält, ohne Ihre Änderungen.
overview_same = Sie enthalten dasselbe.
overview_differs =
    { $count ->
        [one] { $count } Wert ist anders.
       *[other] { $count } Werte sind anders.
    }

## How the timer writes its times: the question that no reading can answer.

byteOrder_title = Die Zeiten dieses Timers nehmen von Zeile zu Zeile ab.
byteOrder_advice = Sie würden zunehmen, wenn die zwei Bytes jeder Zeit vertauscht wären. Vergleichen Sie mit dem, was Sie vom Timer wissen, und wählen Sie, bevor Sie schreiben.
byteOrder_keep = Sie stimmen, wie sie hier stehen
byteOrder_exchange = Vertauschen und neu lesen

## Why there is no connection.

connection_unsupported_title = { unsupportedHere_title }
connection_unsupported_advice = { unsupportedHere_advice }
connection_insecure_title = Der Browser erlaubt hier keine seriellen Ports.
connection_insecure_advice = { restWorks }
connection_policy_title = Der Server dieser Seite verbietet serielle Ports.
connection_policy_advice = { restWorks }
connection_nothing-chosen_title = Kein Adapter wurde gewählt.
connection_nothing-chosen_advice = Drücken Sie „Verbinden“ und wählen Sie den Adapter. Steht er nicht in der Liste, hilft, was unten steht.
connection_not-allowed_title = { connection_insecure_title }
connection_not-allowed_advice = Erlauben Sie dieser Seite serielle Ports in den Einstellungen des Browsers, dann drücken Sie wieder „Verbinden“.
connection_busy_title = Der Adapter lässt sich nicht öffnen.
connection_busy_advice = Meist hat ihn ein anderes Programm oder ein anderer Tab. Schließen Sie es, dann drücken Sie wieder „Verbinden“.
connection_bad-settings_title = Der Adapter nimmt diese Einstellungen nicht an.
connection_bad-settings_advice = { help_steps_usual-settings }
connection_unplugged_title = Der Adapter ist nicht erreichbar.
connection_unplugged_advice = Ziehen Sie ihn ab, stecken Sie ihn wieder an und drücken Sie „Verbinden“. Was Sie eingegeben haben, bleibt.
connection_bad-reply_title = { link_heard_title }
connection_bad-reply_advice = { link_heard_advice }
connection_lost_title = { connection_unplugged_title }
connection_lost_advice = { connection_unplugged_advice }

## Why a job with the timer has ended.

timer_no-answer_title = Der Timer hat nicht geantwortet.
timer_no-answer_advice = Drücken Sie kurz den Schalter des Timers, halten Sie den Infrarotkopf näher als 20 cm an den Timer und versuchen Sie es noch einmal. Was Sie eingegeben haben, bleibt.
timer_bad-reply_title = Die Antwort des Timers kann nicht stimmen.
timer_bad-reply_advice = Versuchen Sie es noch einmal. Wenn es wieder vorkommt: „Optionen“, „Experte“, „Leitung“, „{ line_copyReport }“.
timer_unstable_title = Die Leitung ist zu gestört, um ihr zu trauen.
timer_unstable_advice = Halten Sie den Infrarotkopf näher, nicht in der Sonne, und versuchen Sie es noch einmal.
timer_crowded_title = Vielleicht ist mehr als ein Timer im Strahl.
timer_crowded_advice = Halten Sie andere Timer und Programmiergeräte fern und lesen Sie neu.
timer_other-memory_title = Der aktuelle Speicher ist nicht der auf dem Bildschirm.
timer_other-memory_advice = Lesen Sie neu, bevor Sie schreiben.
timer_memory-unknown_title = Dieser Timer sagt nicht, welcher Speicher aktuell ist.
timer_memory-unknown_advice = Darum kann die Seite keinen anderen Speicher ansehen und dann zurückkehren. Den aktuellen können Sie lesen und schreiben.
timer_memory-left_title = Vielleicht gilt jetzt ein anderer Speicher für den nächsten Flug.
timer_memory-left_advice = Die Seite konnte nicht zu dem Speicher zurückkehren, der aktuell war. Verbinden Sie wieder und wählen Sie den richtigen Speicher für den nächsten Flug, bevor Sie fliegen.
timer_other-timer_title = Das ist nicht der Timer, der vorher geantwortet hat.
timer_other-timer_advice = Die Seite liest ihn. Sehen Sie an, was er enthält, bevor Sie schreiben.
timer_stale_title = Der Timer enthält nicht, was gezeigt wurde.
timer_stale_advice = Nichts wurde geschrieben. Sehen Sie an, was das Schreiben jetzt ändern würde.
timer_changed_title = Der Timer enthält andere Werte als vorher.
timer_changed_advice = Etwas anderes hat ihn geändert, oder es ist ein anderer Timer. Ihre Änderungen sind noch da: Sehen Sie den Unterschied an, bevor Sie schreiben.
timer_stood-still_title = Die Seite stand während der Arbeit still.
timer_stood-still_advice = Danach wurde nichts mehr gesendet: Inzwischen kann ein anderer Timer da sein. Lesen Sie neu.
timer_too-slow_title = Dieser Timer antwortet zu langsam.
timer_too-slow_advice = Seine Antworten brauchen mehr als 3 Sekunden, darum kann die Seite nicht erkennen, welche zu welcher Frage gehört. Danach wurde nichts mehr gesendet. Versuchen Sie einen anderen Adapter oder ein Kabel statt Bluetooth.
timer_undecided_title = { byteOrder_title }
timer_undecided_advice = { byteOrder_advice }
timer_serious_title = Die Prüfung hat etwas Ernstes gefunden.
timer_serious_advice = { timer_stale_advice }
timer_busy_title = Etwas auf dieser Seite oder diesem Computer benutzt den Adapter.
timer_busy_advice = Nichts wurde gesendet. Trennen Sie und verbinden Sie wieder. Was Sie eingegeben haben, bleibt.
timer_port-lost_title = { link_lost_title }
timer_port-lost_advice = { link_lost_advice }
timer_aborted_title = Angehalten.
timer_aborted_advice = Lesen Sie neu, um zu sehen, was der Timer enthält.
timer_closed_title = Getrennt.
timer_closed_advice = Drücken Sie „Verbinden“, um weiterzumachen. Was Sie eingegeben haben, bleibt.

## Replies that are no noise, which is random.

alike_title = Jede Antwort auf { $request } ist auf dieselbe Art beschädigt.
alike_advice = Das ist kein Rauschen: Der Timer oder sein Adapter bildet diese Antworten auf eine Art, die nicht bekannt ist. Schalten Sie in den Optionen „Experte“ ein, öffnen Sie „Leitung“ und drücken Sie „{ line_copyReport }“. Senden Sie den Bericht an die Betreuer (github.com/sidus-timer/sidus-timer/issues).
alike_part = Nur zum Ansehen: { $values }. Alles Übrige ist nicht bekannt.

## Messages that are not about errors.

notes_back_title = Ihre Änderungen sind wieder da.
notes_back_advice = Vergleichen Sie sie mit dem, was der Timer enthält, dann schreiben Sie sie oder machen Sie sie rückgängig.
notes_back-uncertain_title = { notes_back_title }
notes_back-uncertain_advice = Es ist nicht bekannt, ob sie geschrieben wurden. Verbinden Sie den Timer und lesen Sie ihn, bevor Sie fliegen.
notes_moved_title = { timer_changed_title }
notes_moved_advice = { timer_changed_advice }
notes_timer-moved_title = { timer_changed_title }
notes_timer-moved_advice = { timer_changed_advice }
notes_kept_title = Ihre Änderungen sind auf diesem Gerät aufbewahrt.
notes_kept_advice = Sie passen nicht zu dem, was jetzt gelesen wurde. Sie kommen wieder, wenn Sie jenen Speicher wieder lesen; auch die Startseite führt sie auf.
notes_other-kind_title = Jetzt ist eine andere Art von Timer da.
notes_other-kind_advice = { timer_other-timer_advice }
notes_write-completed_title = Der unterbrochene Schreibvorgang ist vollständig.
notes_write-completed_advice = Der Timer wurde noch einmal gelesen und enthält alles, was zu schreiben war.
notes_nothing-written_title = { write_refused }
notes_nothing-written_advice = {""}
notes_not-backed-up_title = { write_unkept_title }
notes_not-backed-up_advice = { keeping_notKept }
notes_select-unanswered_title = Der Timer hat nicht geantwortet, als ein Speicher gewählt wurde.
notes_select-unanswered_advice = Auf andere Anfragen antwortet er. Versuchen Sie es noch einmal, oder senden Sie die Anfrage ohne korrekte Prüfsumme.
notes_backed-up_title = Alle Speicher wurden gelesen, und von jedem ist eine Sicherung aufbewahrt.
notes_backed-up_advice = {""}
notes_strays_title = { timer_crowded_title }
notes_strays_advice = { timer_crowded_advice }
notes_made-laid_title = Die Tabelle zeigt Ihr Programm, nicht das, was der Timer enthält.
notes_made-laid_advice = Nichts wurde geschrieben. Was abweicht, ist markiert. „Rückgängig“ zeigt, was der Timer enthält.
notes_unexpected_title = Auf dieser Seite ist etwas schiefgegangen.
notes_unexpected_advice = Danach wurde nichts mehr gesendet. Laden Sie die Seite neu. Was Sie eingegeben haben, bleibt.

## The flight of the program, and what the servos of the model move.

preview_title = Flugvorschau
preview_guessed = Nicht maßstäblich.
preview_nameServos = Servos benennen…
preview_play = Abspielen
preview_speed = Tempo
preview_time = Zeit des Flugs
preview_launch = Start
preview_at = { $what } bei { $time }
preview_sketch = Das Modell von der Seite, sein Seitenruder von oben
preview_motor_true = Steigflug, Motor läuft
preview_motor_false = Gleitflug, Motor gestoppt
preview_flies = Im Flug
preview_comesDown = DT: Das Modell kommt herunter
preview_duties_rudder = Seitenruder
preview_duties_tailplane = Leitwerk
preview_duties_wing = Flügel
preview_duties_release = Scheibe oder DT-Leine
preview_duties_other = Etwas anderes
preview_duties_none = Unbenutzt
preview_naming_lead = Was jedes Servo bewegt und zwischen welchen Schritten. „Auf“ und „ab“ meinen die Endleiste.
preview_naming_duty = { $servo } bewegt
preview_naming_name = Name für das, was { $servo } bewegt
preview_naming_low = { $servo }, ein Ende in Schritten
preview_naming_high = { $servo }, anderes Ende in Schritten
preview_naming_from = von
preview_naming_to = bis
preview_naming_sense = { $servo }, was mehr Schritte bewirken
preview_naming_otherSense_false = mehr Schritte: auf
preview_naming_otherSense_true = mehr Schritte: ab
preview_naming_rudderSense_false = mehr Schritte: rechts
preview_naming_rudderSense_true = mehr Schritte: links

## The sheet of a program.

print_paper = Papier
print_what = Auf dem Blatt
print_parts_lines = Linien zum Schreiben
print_parts_code = QR-Code
print_nothing = Wählen Sie Programme der Bibliothek, oder öffnen Sie eines.
print_choose = Programme auf diesem Ausdruck: { $chosen }
print_clear = Alle entfernen
print_simulated = simulierter Timer
print_warnings = Vor dem Flug ansehen
print_notes = Notizen
print_codeHint = Die Kamera eines Telefons öffnet dieses Programm, ohne seine Notiz.
print_unfinished =
    { $count ->
        [one] { $count } Feld hat noch keinen Wert: Gedruckt ist der letzte
       *[other] { $count } Felder haben noch keinen Wert: Gedruckt ist der letzte
    }
print_printed = Gedruckt { $date }

## The model in the strip.

recognition_which = Welches Modell?
recognition_change = Modell { $model }: sagen, welches es ist

## A memory with the pilot's name for it: M2 “fly-off”.

memoryNames_named = { $memory } „{ $name }“

## What an earlier job left behind on a timer.

recovery_title = Ein früherer Schreibvorgang wurde unterbrochen.
recovery_when = { $memory }: Schreibvorgang, begonnen { $time }.
recovery_nothing =
    { $missing ->
        [one] Der Timer enthält, was er vorher enthielt: Nichts wurde geschrieben, { $missing } Änderung fehlt.
       *[other] Der Timer enthält, was er vorher enthielt: Nichts wurde geschrieben, { $missing } Änderungen fehlen.
    }
recovery_part =
    { $missing ->
        [one] Der Timer enthält { $values } aus jenem Schreibvorgang; { $missing } Wert ist noch wie vorher.
       *[other] Der Timer enthält { $values } aus jenem Schreibvorgang; { $missing } Werte sind noch wie vorher.
    }
recovery_foreign =
    { $count ->
        [one] { $count } Wert im Timer ist weder der alte noch aus jenem Schreibvorgang. Ist es ein anderer Timer, oder hat etwas anderes den Wert geändert?
       *[other] { $count } Werte im Timer sind weder die alten noch aus jenem Schreibvorgang. Ist es ein anderer Timer, oder hat etwas anderes die Werte geändert?
    }
recovery_sure = Diese Seite kann Timer derselben Art nicht unterscheiden. Machen Sie nur weiter, wenn das der Timer jenes Schreibvorgangs ist.
recovery_finish = Zu Ende schreiben…
recovery_goBack = Alte Werte zurückschreiben…
recovery_leave = So lassen
recovery_otherTimer = Es ist ein anderer Timer
recovery_sameTimer = Es ist derselbe Timer: zeigen, was zu schreiben war
recovery_compare = Vergleichen
recovery_before = Vorher
recovery_elsewhere = Ein Schreibvorgang in { $memory } eines Timers dieser Art wurde unterbrochen. Lesen Sie { $memory }, um zu sehen, was dieser Speicher enthält.
recovery_left = Die Arbeit an mehreren Speichern wurde unterbrochen. Jetzt gilt { $current } für den nächsten Flug. Vorher war es { $original }.
recovery_mayFly = Vielleicht gilt { $memory } für den nächsten Flug: Das Wählen wurde unterbrochen.
recovery_mayNotFly = Die Arbeit an mehreren Speichern wurde unterbrochen. Vielleicht gilt für den nächsten Flug nicht { $original }, sondern ein anderer Speicher.
recovery_unknownMemory = ein unbekannter Speicher

## The backups.

backups_title = Sicherungen
backups_empty = Vor jedem Schreiben bewahrt die Seite hier auf, was der Timer enthält.
backups_reasons_write = vor dem Schreiben
backups_reasons_memories = alle Speicher

## How the page looks.

theme_title = Farben
theme_names_system = System
theme_names_light = Hell
theme_names_dark = Dunkel
theme_names_sun = Sonne

## The settings of the page.

settings_look = Aussehen
settings_expert = Experte: Leitung zeigen
settings_expertHint = Die Leitung zeigt jedes Byte zwischen dieser Seite und dem Timer. Der Prüfstand bietet einen Sprung an, der nicht dokumentiert ist.
settings_kept = Was dieses Gerät aufbewahrt

## A saved program as a link and a QR code, and back.

share_offer_lead = Der Link enthält das ganze Programm. Nichts geht an einen Server.
share_offer_link = Link
share_offer_copy = Link kopieren
share_offer_scan = Richten Sie die Kamera des anderen Geräts auf diesen Code, oder senden Sie den Link.
share_offer_qr = QR-Code von „{ $name }“
share_offer_cut = Das Ende der Notiz passt nicht in den QR-Code. Der Link enthält die ganze Notiz.
share_offer_tooLong = Zu lang für einen QR-Code. Senden Sie den Link.
share_received_title = Ein Programm aus einem Link
share_received_lead = Bisher zeigt die Seite es nur. Nichts wird aufbewahrt und nichts in einen Timer geschrieben.
share_received_known = Die Bibliothek hat diese Werte schon: { $name }.
share_received_modelChoice = Behalten unter
share_received_newModel = Neues Modell „{ $name }“
share_received_keep = In der Bibliothek behalten
share_received_discard = Nicht behalten
share_received_unwritten = Was Sie eingegeben haben, bleibt: „Rückgängig“ oder die Startseite bringt es zurück.
share_damaged_title = Dieser Link ist nicht lesbar.
share_damaged_bad = Er ist abgeschnitten oder beschädigt oder nicht von dieser Seite. Bitten Sie noch einmal darum.
share_paste_title = Link einfügen…
share_paste_lead = Einen QR-Code öffnet die Kamera eines Telefons von selbst. Hier können Sie einen Link einfügen.
share_paste_show = Zeigen
share_paste_notLink = Das ist kein Link zu einem Programm.

## A DT for trimming that is about to be flown. The page asks before the pilot disconnects, and at a contest round.

shortDt_held = DT von { $memory } ist { $dt }.
shortDt_heldHere = DT ist { $dt }.
shortDt_ask =
    { $remembered ->
        [true] Auf { $back } zurücksetzen?
       *[false] Auf { $back } setzen?
    }
shortDt_putBack =
    { $remembered ->
        [true] DT auf { $back } zurücksetzen…
       *[false] DT auf { $back } setzen…
    }
shortDt_disconnect = So trennen: { $memory }, DT{"\u00a0"}{ $dt }
shortDt_disconnectHere = So trennen: DT{"\u00a0"}{ $dt }
shortDt_blocked = Etwas, was Sie eingegeben haben, lässt sich noch nicht schreiben. Berichtigen Sie es, bevor Sie DT zurücksetzen.
shortDt_settings_limit = DT gilt als kurz unter
shortDt_settings_hint = Eine kürzere DT-Zeit ist rot, und die Seite fragt nach, bevor Sie trennen. Ist die Grenze 0 s, fragt sie nie.

## The start, before anything was read.

start_title = Ihren Sidus-Timer einstellen
start_lead = Lesen Sie, was er enthält, ändern und schreiben Sie es, und sehen Sie es verifiziert. Nichts verlässt dieses Gerät.
start_adapter = Stecken Sie den Adapter an
start_firefox = Firefox fragt zuerst nach einer Erlaubnis, und bei jedem Laden der Seite nach dem Port.
start_android = Ein Telefon verbindet sich über Bluetooth; ein Kabel braucht Android { firstVersions_androidCable } und Chrome { firstVersions_android }.
start_readyOffline = Bereit ohne Netz
start_install = Installieren
start_picture_example = Beispiel: ein F1Q
start_picture_kept = Aufbewahrt { $time }
start_models_title = Meine Modelle
start_models_none = Bewahren Sie die Programme jedes Modells auf, mit Notizen.
start_models_programs =
    { $count ->
        [one] { $count } Programm
       *[other] { $count } Programme
    }
start_models_library = Bibliothek öffnen
start_programs_title = Nicht fertig
start_programs_made = { $timer }, neu
start_programs_changesOf = { $timer }, Änderungen
start_programs_sure = Endgültig löschen?
start_simulatedTitle = Kein Timer da?
start_simulatedLead = Ein simulierter antwortet wie ein echter, Byte für Byte.
start_simulated = Simulierten { $name }-Timer probieren
start_backups =
    { $count ->
        [one] { $count } Sicherung, angelegt vor dem Schreiben. Die letzte: { $last }.
       *[other] { $count } Sicherungen, angelegt vor dem Schreiben. Die letzte: { $last }.
    }

## The dialog that makes a program without a timer.

newProgram_title = Neues Programm…
newProgram_timerClass = Klasse
newProgram_functions = Funktionen, ohne Start und DT
newProgram_servos = Servos
newProgram_from = Beginnen mit
newProgram_beginnings_usual = Übliche Zeiten, Servos in der Mitte
newProgram_beginnings_nothing = Alle Zeiten und Stellungen 0
newProgram_caution = Die Stellungen Ihres Modells sind hier nicht bekannt. Stellen Sie jede ein, bevor Sie schreiben.
newProgram_make = Programm anlegen

## The picture of a program over time.

timeline_title = Zeitachse
timeline_compareBefore = vor dem Folgen
timeline_picture = Servostellungen über der Zeit
timeline_description = { $servos } und { $functions } über der Zeit, DT bei { $dt }. Die Tabelle enthält alle Werte.
timeline_descriptionMotor = { $servos } und { $functions } über der Zeit, DT bei { $dt }, Motorstopp bei { $motorStop }. Die Tabelle enthält alle Werte.
timeline_functions =
    { $count ->
        [one] { $count } Funktion
       *[other] { $count } Funktionen
    }
timeline_servos =
    { $count ->
        [one] { $count } Servo
       *[other] { $count } Servos
    }
timeline_keysToEdit = Pfeile gehen von Marke zu Marke und von Servo zu Servo, Plus und Minus zoomen, 0 zeigt alles. Enter geht zu den Griffen: Pfeile verschieben sie, Escape kommt zurück.
timeline_ask = Zeigen oder tippen, um abzulesen
timeline_finer = Feiner
timeline_steps =
    { $position ->
        [one] { $position } Schritt
       *[other] { $position } Schritte
    }
timeline_stepsUnit = Schritte
timeline_notKnown = Nicht bekannt: Die Zeiten nehmen ab
timeline_tools = Ansicht
timeline_zoomIn = Vergrößern
timeline_zoomOut = Verkleinern
timeline_fit = Alles zeigen
timeline_passedOver = { $slot } wird übersprungen: { $next } kommt zur selben Zeit.
timeline_goesBack = { $next } kommt früher als { $slot }. Es ist nicht bekannt, was der Timer im schattierten Teil tut.

## A new version of the page.

update_ready = Eine neue Version ist bereit.
update_waits = Sie startet, wenn Sie trennen und nichts offen oder ungespeichert ist.
update_take = Jetzt benutzen
update_news = Was neu ist

## The version of this page.

aboutPage_title = Diese Seite
aboutPage_version = Sidus Timer { $version }.
aboutPage_offline = Die ganze Seite ist auf diesem Gerät: Sie geht ohne Netz.
aboutPage_notOffline = Die Seite ist noch nicht auf diesem Gerät: Öffnen Sie sie einmal mit Netz.
aboutPage_licences = Lizenzen

## The views of the page and the links between them.

views_title = Ansichten
views_names_program = Programm
views_names_memories = Speicher
views_names_bench = Prüfstand
views_names_library = Bibliothek
views_names_line = Leitung
views_names_settings = Optionen
views_names_print = Drucken
views_names_help = Hilfe
views_print = Drucken…
views_share = Teilen…
views_noTimer_memories = Verbinden Sie einen Timer, um seine Speicher zu sehen. Sicherungen stehen unten.
views_noTimer_bench = Verbinden Sie einen Timer, um seine Servos zu bewegen.

## The strip above every view: the timer, its memory, DT, motor stop, and what is known.

strip_panel = Speicher und mehr
strip_tried = { $count } probiert
strip_notCertain = ungewiss
strip_asRead = zuletzt gelesen
strip_notValid = ungültig
strip_ofSetting =
    { $changes ->
        [0] gespeichert
       *[other] { $changes } ungespeichert
    }
strip_made = in keinem Timer

## The list of commands.

palette_title = Befehle
palette_search = Geben Sie ein, was Sie tun wollen
palette_nothing = Kein Befehl heißt so, oder er geht gerade nicht.
palette_ctrl = Strg+{ $key }

## In place of a part of the page that is being loaded.

parts_coming = Lädt
parts_failed = Ein Teil dieser Seite konnte nicht geladen werden.
parts_again = Noch einmal

## Which model it is.

whichModel_recognition_same = Das ist { $model }, Stand { $when }.
whichModel_recognition_like =
    { $count ->
        [one] Das ist wie { $model }, { $count } Wert ist anders. Ist es { $model }?
       *[other] Das ist wie { $model }, { $count } Werte sind anders. Ist es { $model }?
    }
whichModel_recognition_several = Das kann { $models } sein. Welches Modell ist es?
whichModel_or = { $names } oder { $last }
whichModel_others = { $count } weitere
whichModel_recognition_unknown = Dieser Timer ist hier nicht bekannt. Welches Modell ist es?
whichModel_recognition_yes = Ja, { $model }
whichModel_recognition_choose = Wählen…
whichModel_recognition_ok = OK
whichModel_recognition_dialog_title = Welches Modell ist es?
whichModel_recognition_dialog_lead = Ein Timer kennt sein Modell nicht. Die Seite vergleicht, was er enthält, mit dem, was sie in jedem Modell zuletzt gesehen hat.
whichModel_recognition_dialog_said = Sie haben gesagt, dass es { $model } ist.
whichModel_recognition_dialog_moreMemories = Lesen Sie auch die anderen Speicher: Vielleicht unterscheiden sie die Modelle.
whichModel_recognition_dialog_none = Kein solches Modell dieser Klasse.
whichModel_recognition_dialog_newModel = Ein neues Modell
whichModel_recognition_dialog_keep = Als neues Modell behalten
whichModel_memoryNames_label = Name von { $memory }
whichModel_memoryNames_give = Benennen
whichModel_crossing_title = Das sind Werte von { $from }, aber dieser Timer sieht aus wie der von { $to }.
whichModel_crossing_advice = Mit den Werten eines anderen Modells können Sie dieses verlieren. Sehen Sie das Modell vor sich an.
whichModel_crossing_confirm = Werte von { $from } in den Timer von { $to } schreiben.
whichModel_crossing_memoryOf = { $memory } von { $model }

## A write, from the difference to the verdict.

write_title = In den Timer schreiben
write_lead = So ändert sich { $memory }. Alles andere bleibt, wie es ist.
write_target = Schreiben in
write_nothing = Nichts ist anders. Der Timer wird zurückgelesen und verglichen.
write_field = Wert
write_from = Timer enthält
write_to = Wird enthalten
write_wasRead = Zuvor gelesen
write_moved_model_title = Dieser Timer scheint jetzt zu einem anderen Modell zu gehören.
write_moved_model_advice = Nichts wurde geschrieben. Sehen Sie die Namen der Modelle an.
write_moved_edits_title = Das Programm hat sich geändert, seit das gezeigt wurde.
write_unkept_title = Dieses Gerät konnte keine Sicherung dessen aufbewahren, was der Timer jetzt enthält.
write_unkept_advice = Dieser Speicher ist noch, wie er war. Ohne Sicherung weitermachen?
write_sideBySide = Werte: { $names }
write_withoutCopy = Ohne Sicherung weiter
write_safety = Der Propeller ist abgenommen oder das Modell wird festgehalten, und der Timer ist nicht scharf.
write_acknowledge = Ich habe das gelesen und will es trotzdem schreiben.
write_stillToTick = Noch anzuhaken: { $ticks }.
write_ticks_model = anderes Modell
write_ticks_warnings = Warnungen
write_ticks_safety = Propeller
write_move_why = Dieser Timer scheint Stellungen nur bei der Funktion zu behalten, bei der seine Servos stehen. Bewegen sich die Servos nicht, wird er diese Stellungen wahrscheinlich nicht behalten.
write_move_label = Servos auf jede Funktion stellen, bevor deren Stellungen geschrieben werden.
write_move_hint = Halten Sie das Modell sicher fest; nichts darf den Servos im Weg sein.
write_move_notHeld_title = Der Timer hat die Stellungen bestätigt, aber nicht behalten.
write_move_notHeld_advice = Wahrscheinlich behält dieser Timer sie nur bei der Funktion, bei der seine Servos stehen. Schreiben Sie noch einmal, und lassen Sie dabei die Servos auf jede Funktion stellen.
write_move_again = Nochmals schreiben…
write_start =
    { $count ->
        [0] Zurücklesen und vergleichen
        [one] { $count } Änderung schreiben
       *[other] { $count } Änderungen schreiben
    }
write_stages_read = Liest
write_stages_write = Schreibt
write_stages_verify = Liest zurück
write_stages_repair = Berichtigt
write_stopping = Hält nach dieser Anfrage an
write_stoppingBack = Hält an: zuerst zurück zum Speicher von vorher
write_verified_title = Verifiziert.
write_verified_advice = Der Timer wurde zurückgelesen und enthält, was gezeigt wurde.
write_verdict = { $memory } verifiziert { $time }
write_asItIs = wie es ist
write_insteadOf = statt { $value }
write_wanted = Zu schreiben
write_readBack = Zurückgelesen
write_differs_title = Der Timer hat nicht jeden Wert angenommen.
write_differs_advice = Der Timer wurde zurückgelesen. Er enthält hier andere Werte:
write_unknown_title = Es ist ungewiss, was der Timer enthält.
write_unknown_advice = Der Timer konnte nicht vollständig zurückgelesen werden. Lesen Sie neu, dann schreiben Sie, was noch abweicht. Ihre Änderungen sind noch da.
write_cut = { $memory }: Das Schreiben wurde unterbrochen.
write_strayed_title = { $memory } wurde während des Schreibens aktuell.
write_strayed_advice = Einige der Werte sind jetzt vielleicht in { $memory }. Lesen Sie diesen Speicher und sehen Sie ihn ganz durch, bevor Sie damit fliegen.
write_refused = Nichts wurde geschrieben.
write_status_differs = anders
write_status_unknown = nicht bekannt
write_putBack = vom Timer selbst geändert, zurückgesetzt

## What the parts of the page that are loaded first say.

name = Sidus Timer
classNames_Q = F1Q
classNames_B = F1B
classNames_E = F1E
unknownClass = Klasse { $letter }
memoryName = M{ $number }
servoName = S{ $number }
slotName =
    { $kind ->
        [start] Start
        [dt] DT
       *[function] Funktion { $slot }
    }
within_slot =
    { $kind ->
        [start] Start
        [dt] DT
       *[function] Funktion { $slot }
    }
within_idleThrottle = Leerlauf
slotShort =
    { $kind ->
        [start] Start
        [dt] DT
       *[function] { $slot }
    }
about = { $name }:
previous = Zurück
next = Weiter
pause = Pause
less = { $what }: weniger
moreOf = { $what }: mehr
seconds = { $time }{" "}s
times_minutes = { $minutes }{" "}min
times_minutesSeconds = { $minutes }{" "}min { $seconds }{" "}s
times_units_s = s
times_units_min = min
times_figure = { $text } { $unit }
times_asSeconds = { $seconds }{" "}s, { $clock }
times_meaning = { $field }: was gemeint ist
header_firmware = Firmware { $firmware }
header_simulated = simuliert
header_connect = Verbinden
header_choosePort = Anderen Adapter wählen
header_closeProgram = Programm schließen
header_disconnect = Trennen
header_stop = Stopp
program_tableCaption = Zeit und Servostellungen jeder Funktion
program_slot = Funktion
program_time = Zeit
program_memory = Speicher
program_memoryUnknown = Dieser Timer sagt nicht, welcher Speicher aktuell ist. Darum ist nicht bekannt, welcher für den nächsten Flug gilt.
program_memoryOpen = Es ist nicht bekannt, welcher Speicher für den nächsten Flug gilt. Wählen Sie einen dafür, oder lesen Sie neu.
program_dt = DT
program_motorStop = Motorstopp
program_motor = Motor
program_idleThrottle = Leerlauf
program_throttle = Leerlauf
program_idleThrottleUnit = Einheit unbekannt
program_reserved = reserviert { $time }
program_timeOf = { $slot }, Zeit
program_motorStopTime = Motorstopp, Zeit
program_positionOf = { $slot }, { $servo }
program_shortDt = DT kurz
program_changes =
    { $count ->
        [one] { $count } Änderung
       *[other] { $count } Änderungen
    }
program_undoAll = Alles rückgängig
program_read = Neu lesen
program_connectAndWrite = Verbinden und schreiben…
program_write =
    { $count ->
        [0] Schreiben…
        [one] { $count } Änderung schreiben…
       *[other] { $count } Änderungen schreiben…
    }
program_picture = Bild
program_table = Tabelle
program_blocked = Noch lässt sich nichts schreiben. { $field }: { $why }
program_findings = Prüfung
program_noFindings = Nichts Unübliches.
program_absolute = Gezeigt ab dem Start. Es ist nicht bekannt, ob dieser Timer ab dem Start oder ab der Funktion davor zählt.
program_severity_error = Nicht schreibbar
program_severity_serious = Ernst
program_severity_warning = Unüblich
program_reading = Liest den Timer
program_selecting = Wechselt den Speicher
otherTab_holdsSince = Sidus Timer ist in einem anderen Tab offen, seit { $since }.
otherTab_holds = Sidus Timer ist in einem anderen Tab offen.
otherTab_takeOver = Hier benutzen
otherTab_busy = Der andere Tab arbeitet mit dem Timer. Sobald das zu Ende ist, öffnet sich die Seite hier.
otherTab_gone = Der andere Tab antwortet nicht. Schließen Sie ihn, dann laden Sie diese Seite neu.
disturbed = Antworten fehlen oder sind beschädigt: Ist der Timer wach, und der Infrarotkopf nahe, nicht in der Sonne? Das endet spätestens in { $seconds } s.
cancel = Abbrechen
close = Schließen
copy = Kopieren
copied = Kopiert.
copyByHand = Der Browser lässt diese Seite nicht kopieren. Kopieren Sie es von hier.
dismiss = Ausblenden
done = Fertig
undo = Rückgängig
open = Öffnen
save = Speichern
delete = Löschen
notNow = Jetzt nicht
label_language = Sprache
label_name = Name
label_note = Notiz
label_model = Modell
label_search = Suchen
noModel = Kein Modell
more = Und noch { $count }.
showMore = Noch { $count } zeigen
of = { $button }: { $name }
notFitting = Es passt nicht zum verbundenen Timer. Trennen Sie, um es zu öffnen.
notKept = Dieser Browser hat es nicht aufbewahrt: Es geht verloren, wenn die Seite geschlossen wird.

## The walk through the open questions of docs/protocol.md with a real timer.

settle_title = Mit Ihrem Timer klären
settle_lead = Nicht alles ist bekannt darüber, wie diese Timer sprechen. In fünfzehn Minuten klärt Ihrer, was offen ist. Jeder probierte Wert wird zurückgesetzt. Halten Sie das Programmiergerät bereit.
settle_safe = Der Propeller ist abgenommen oder der Motor ist abgesteckt, und der Timer ist nicht scharf.
settle_danger = Jetzt kann sich etwas bewegen. Ist der Propeller abgenommen oder der Motor abgesteckt? Sehen Sie noch einmal nach.
settle_blocked = Kümmern Sie sich zuerst um die Meldung im farbigen Band oben, und behalten Sie das Probierte oder setzen Sie es zurück.
settle_readIt = Timer lesen
settle_which = Welche zeigt das Programmiergerät?
settle_tryHint = Bewegen Sie die Servos mit den Tasten der Seite und warten Sie, bis sie stillstehen. Dann probieren Sie eine Stellung: Sie wird geändert und binnen Sekunden zurückgesetzt. Beobachten Sie die Servos.
settle_tryIt = Eine Stellung probieren
settle_moved = Die alte Stellung ist zurück: Die Seite hat sie zurückgelesen. Hat sich ein Servo bewegt, als die neue probiert wurde?
settle_ask = Mit vier Nullen fragen
settle_unknown = Ich weiß es nicht
settle_send = Senden Sie die Datei mit diesem Formular
settle_names_order = Das niedrige Byte einer Zeit kommt zuerst
settle_names_unit = Zeiten sind in Hundertstelsekunden
settle_names_count = Zeiten zählen ab dem Start
settle_names_memories = Der erste Speicher hat die Nummer 0
settle_names_zeros = Vier Nullen genügen
settle_names_layout = Die Funktion kommt vor dem Servo
settle_names_stores = Stellungen bleiben bei jeder Funktion
settle_names_moves = Eine geschriebene Stellung bewegt ihr Servo
settle_names_unlock = Buchstabe, der UNLOCK beantwortet
settle_names_delay = Übliche Dauer bis zur Antwort
settle_names_reserved = Reservierte Zeit, wie gelesen
settle_yes = Ja
settle_no = Nein
settle_unnumbered = Keine Nummer wird genannt
settle_there = Nur wo die Servos stehen
settle_delay = { $ms } ms
settle_open = Nicht geklärt
