### Nederlands: alles wat de pagina zegt. Het voorbeeld is en.ftl.
###
### Translated without a pilot of that language; corrections welcome (docs/translating.md).

## Moving servos and motor from the page.

bench_slots = Zetten op
bench_elsewhere = Servo’s en motor werken met { $memory }, het geheugen voor de volgende vlucht. Toon { $memory } om ze te bewegen.
bench_trim = Trimmen bij { $slot }
bench_at = Servo’s staan bij { $slot }
bench_atNone = Het is niet bekend waar de servo’s staan.
bench_moveMaybe = Er kwam geen antwoord. De servo’s kunnen toch bewogen hebben. Kijk naar het model.
bench_unlocked = De motor is ontgrendeld. De propeller kan gaan draaien.
bench_unlockMaybe = Er kwam geen antwoord. De motor kan toch ontgrendeld zijn. Blijf uit de buurt van de propeller.
bench_jumped = De timer heeft de sprong bevestigd.
bench_here = servo’s hier
bench_waits = Wacht op “Schrijven”.
bench_bring = Servo’s op { $slot } zetten
bench_follow = Servo’s volgen de posities
bench_followHint = Eerst leest de pagina de timer en bewaart een back-up. Daarna wordt elke positie die je wijzigt in de rij waar de servo’s staan, meteen in de timer geschreven, en beweegt de servo ervan.
bench_followingNow = Servo’s volgen: een positie die je wijzigt in de rij waar de servo’s staan, wordt meteen in de timer geschreven.
bench_stopFollowing = Volgen stoppen
bench_ended_over = De servo’s volgen niet meer.
bench_ended_memory = De servo’s volgen niet meer: een ander geheugen is het huidige, of is dat misschien.
bench_ended_strayed = Terwijl de servo’s volgden, werd een ander geheugen het huidige. Het heeft misschien enkele van de posities overgenomen: kijk het helemaal na voordat je ermee vliegt.
bench_ended_unlike = De servo’s volgen niet meer: de timer deed niet wat hij bevestigde.
bench_ended_failed = De servo’s volgen niet meer: de timer antwoordde niet.
bench_notTaken = { $field }: in de timer staat { $held }, niet { $wanted }.
bench_beside =
    { $more ->
        [0] Daarnaast gewijzigd: { $named }.
        [one] Daarnaast gewijzigd: { $named }; en nog { $more } waarde.
       *[other] Daarnaast gewijzigd: { $named }; en nog { $more } waarden.
    }
bench_triedHere =
    { $more ->
        [0] Geprobeerd: { $named }.
        [one] Geprobeerd: { $named }; en nog { $more } positie.
       *[other] Geprobeerd: { $named }; en nog { $more } posities.
    }
bench_triedAndWaiting =
    { $waiting ->
        [0] { $tried } geprobeerd in de timer
        [one] { $tried } geprobeerd in de timer, { $waiting } wacht op “Schrijven”
       *[other] { $tried } geprobeerd in de timer, { $waiting } wachten op “Schrijven”
    }
bench_triedIn = Er zijn posities geprobeerd in { $memory }.
bench_decide = Behouden wat geprobeerd is, of terugzetten wat de timer daarvoor bevatte?
bench_keep = Behouden
bench_putBack = Terugzetten…
bench_unlock = Ingedrukt houden: UNLOCK
bench_unlockHold = Blijf drukken
bench_unlockHint = De propeller kan gaan draaien. Houd het model vast en je handen weg van de propeller. Druk dan op de knop en houd die ingedrukt.
bench_experimental = Experimenteel
bench_jumpHint = Springt naar de functie na een vroege DT. Wat er precies gebeurt, is niet gedocumenteerd: servo’s kunnen bewegen.
bench_jump = Sprong…
bench_jumpSure = Sprong nu sturen

## The log of flights.

flights_title = Vluchten
flights_empty_title = Nog geen vlucht genoteerd.
flights_empty_advice = Lees of schrijf een timer en druk dan op “{ flights_flying_button }”.
flights_failed = De browser kan de bibliotheek nu niet lezen. Sluit andere tabbladen van deze pagina en probeer het opnieuw.
flights_flying_button = Vlucht noteren
flights_flying_purpose = Noteert een vlucht met wat de timer bevat.
flights_flying_logged = Vlucht genoteerd { $time }
flights_flying_fillIn = Invullen
flights_flying_again = Nog eens noteren
flights_row_round = Ronde { $round }
flights_row_wind = { $wind } m/s
flights_row_temperature = { $degrees } °C
flights_row_noResult = geen resultaat
flights_row_changed = { $values } gewijzigd
flights_row_otherTimer = andere timer
flights_totals_flights =
    { $count ->
        [one] { $count } vlucht
       *[other] { $count } vluchten
    }
flights_totals_best = beste { $time }
flights_totals_average = gemiddeld { $time }
flights_filter_of = Vluchten van { $name }
flights_filter_clear = Alles tonen
flights_form_title = Vlucht
flights_form_result = Resultaat
flights_form_resultHint = Seconden, of minuten zoals 2:58.
flights_form_readAs = { $time }, { $seconds } s
flights_form_propose = Noteren: { $facts }
flights_form_full = Volle ronde, 180 s
flights_form_round = Ronde
flights_form_flyOff = Fly-off
flights_form_wind = Wind
flights_form_windUnit = m/s
flights_form_temperature = Temperatuur
flights_form_temperatureUnit = °C
flights_form_when = Datum, plaats, model
flights_form_date = Datum en tijd
flights_form_noOffset = De tijdzone van het veld is niet bekend: dit is de tijd van dit apparaat.
flights_form_place = Plaats
flights_form_flown = Wat is gevlogen
flights_form_open = Programma ervan openen
flights_form_unreadable_not-a-number = Geen getal.
flights_form_unreadable_not-a-time = Geen tijd: typ seconden zoals 178, of minuten zoals 2:58.
flights_form_unreadable_too-fine = { unreadable_too-fine }
flights_form_range = { $min } tot { $max } { $unit }.
flights_form_shortDt = DT was { $dt } bij deze vlucht.
flights_score_open = Scorekaart
flights_score_maximum = Max per ronde
flights_score_none = Zonder max telt elk resultaat volledig.
flights_score_maximumOf = Max voor { $round }
flights_score_counted = Telt mee (s)
flights_score_notCounted = telt niet mee
flights_score_count = Deze telt
flights_score_noRound = geen ronde
flights_score_total = Totaal
flights_score_copy = Als tekst kopiëren
flights_csv_save = Als tabel opslaan (CSV)
flights_csv_columns_date = Datum
flights_csv_columns_time = Tijd
flights_csv_columns_zone = Tijdzone
flights_csv_columns_place = Plaats
flights_csv_columns_model = Model
flights_csv_columns_setting = Programma
flights_csv_columns_timerClass = Klasse timer
flights_csv_columns_memory = Geheugen
flights_csv_columns_dt = DT (s)
flights_csv_columns_motorStop = Motorstop (s)
flights_csv_columns_wind = Wind (m/s)
flights_csv_columns_temperature = Temperatuur (°C)
flights_csv_columns_round = Ronde
flights_csv_columns_result = Resultaat (s)
flights_csv_columns_maximum = Max (s)
flights_csv_columns_note = Notitie
flights_section_all = Alle vluchten ervan

## Values that are unusual, or cannot be written.

findings_time-not-whole = { unreadable_not-a-whole-number }
findings_time-out-of-range = Het moet { $min } tot { $max } zijn.
findings_position-not-whole = { unreadable_not-a-whole-number }
findings_position-out-of-range = Het moet { $min } tot { $max } zijn.
findings_throttle-not-whole = { unreadable_not-a-whole-number }
findings_throttle-out-of-range = Het moet { $min } tot { $max } zijn.
findings_position-as-read = Gelezen als { $value }, boven de laatste stap, { $max }. Het blijft zo zolang je het niet wijzigt.
findings_time-falls = Dit komt eerder dan de functie erboven ({ $previous }).
findings_time-repeats = Dezelfde tijd als de functie erboven, { $previous }.
findings_position-never-reached = Dezelfde tijd als de functie erboven, { $previous }. De posities van de functie erboven worden nooit bereikt.
findings_motor-stop-after-dt = De motor stopt pas na DT ({ $dt }): het model komt met draaiende motor naar beneden.
findings_motor-run-long = De motor draait langer dan { $limit }, de grens voor F1Q.
findings_time-outside-manual = De handleiding staat { $min } tot { $max } toe.
findings_time-too-fine = De handleiding gaat per { $step }: de timer kan afronden.
findings_dt-short = Korter dan { $limit }.
findings_dt-moves-nothing = Bij DT beweegt geen servo: de timer brengt het model niet naar beneden.
findings_throttle-unusual = Meer dan { $limit } is ongewoon. De eenheid is niet bekend.
findings_class-unknown = De klasse “{ $timerClass }” is niet bekend: de regels ervan zijn niet gecontroleerd.

## Why a text in a field is no value.

unreadable_empty = Leeg: typ een waarde.
unreadable_not-a-time = Geen tijd: typ seconden zoals 12,5, of minuten zoals 2:05.
unreadable_too-fine = Fijner dan een honderdste seconde.
unreadable_not-a-whole-number = Het moet een geheel getal zijn.
unreadable_ambiguous = Dit kun je op meerdere manieren lezen: kies er een.

## For a page that cannot reach a timer here.

restWorks = Alles behalve de verbinding werkt ook hier.

## What an Android phone needs.

firstVersions_android = 148
firstVersions_androidBluetooth = 138
firstVersions_lastBluetoothOnly = 147
firstVersions_androidCable = 17
android = Chrome { firstVersions_android } of later ({ firstVersions_androidBluetooth } tot { firstVersions_lastBluetoothOnly } alleen via Bluetooth); een kabel vraagt Android { firstVersions_androidCable }

## For every browser about which nothing more is known. docs/connection.md names the first versions.

unsupportedHere_title = Deze browser kan geen timer bereiken.
unsupportedHere_advice = Gebruik op een computer een actuele Chrome, Edge, Opera of Firefox; op een telefoon Chrome op Android. { restWorks }

## Replaces the sentence above where the browser's name tells more.

unsupported_brave_title = Brave bereikt een timer alleen als je het toestaat.
unsupported_brave_advice = Open brave://flags/#brave-web-serial-api, zet het op Enabled en druk op Relaunch. { restWorks }
unsupported_ios_title = Op een iPhone of iPad kan geen enkele browser een timer bereiken.
unsupported_ios_advice = Gebruik een computer, of Chrome op een Android-telefoon. { restWorks }
unsupported_android_title = { unsupportedHere_title }
unsupported_android_advice = Gebruik op Android { android }. { restWorks }

## What a saved program held before it was saved over.

versions_title = Eerdere versies
versions_until = Tot{"\u00a0"}{ $when }
versions_changed =
    { $more ->
        [0] toen { $change }
       *[other] toen { $change } en nog{"\u00a0"}{ $more }
    }
versions_otherLayout = toen waarden voor een andere timer
versions_same = Het opgeslagen programma bevat dit nu.
versions_goBack = Terug naar deze

## Two programs side by side.

compare_title = Vergelijken
compare_open = Vergelijken…
compare_second = met
compare_screen = Op het scherm
compare_timer = Timer, { $memory }
compare_groups_now = Nu
compare_groups_settings = Opgeslagen programma’s
compare_setting = { $model } · { $name }
compare_backup = { $memory } · { $when }
compare_backupOf = { $model } · { $memory } · { $when }
compare_nothing = Dit apparaat heeft geen ander programma van deze klasse en indeling.
compare_take = Overnemen
compare_takeOf = { $value } voor { $field } overnemen
compare_takeHint = “Overnemen” kopieert een waarde naar het programma op het scherm.

## How a backup differs from what its timer holds.

modelBackups_same = zoals in de timer { $when }
modelBackups_differs =
    { $count ->
        [one] { $count } waarde anders dan in de timer { $when }
       *[other] { $count } waarden anders dan in de timer { $when }
    }
modelBackups_now = nu

## Undo, redo, and edits of many fields at once.

edits_redoButton = Opnieuw
edits_undo = Ongedaan maken: { $step }
edits_redo = Opnieuw: { $step }
edits_steps_change = { $what } gewijzigd
edits_steps_shift = { $what } verschoven met { $by }
edits_steps_step-servo = { $what } met { $steps }
edits_steps_step-servo-from = { $what } met { $steps }, vanaf { $from }
edits_steps_paste = { $count } geplakt
edits_steps_fill = { $count } omlaag gevuld
edits_steps_revert-all = alles teruggezet
edits_steps_open = { $what } geopend
edits_steps_keep-tried = behouden wat geprobeerd is
edits_opened = “{ $name }”
edits_openedUnnamed = ander programma
edits_refused_start = De start heeft geen tijd om te wijzigen.
edits_refused_later-out-of-range = Een latere functie zou buiten { $min } tot { $max } vallen.
edits_refused_unreadable = Een tekst die geen waarde is, staat in de weg. Verbeter die eerst.
edits_refused_interval-disagrees = Dit interval past niet bij de tijden van de twee rijen.
edits_refused_no-place = Het programma heeft deze plaats niet.
edits_refused_twice = Deze plaats komt twee keer voor, met verschillende waarden.
edits_refused_too-large = De tabel is te groot: hoogstens { $cells } cellen worden gelezen. De rest is weggelaten.
edits_beforeLaunch = Dit zou voor de start zijn.
edits_nothingDone = Er is niets gewijzigd.
edits_cells =
    { $count ->
        [one] { $count } waarde
       *[other] { $count } waarden
    }
edits_change = { $field }: { $from } → { $to }
edits_field_putBack = { $field } terugzetten
edits_field_putBackTo = { $field } terugzetten op { $figure }
edits_sheet_title = Toetsen voor { $field }
edits_sheet_erase = Laatste cijfer wissen
edits_sheet_putBack = Terugzetten
edits_sheet_selectRange = Bereik kiezen
edits_sheet_goTo = Naar { $name }
edits_table_explain = Wat de waarden zijn
edits_table_interval = Interval
edits_table_countedFrom = vanaf { $row }
edits_table_switch = Tijd of interval
edits_table_intervalOf = { $slot }, interval
edits_table_range_title = Gekozen bereik
edits_table_range_pick = Tik nu op een andere cel.
edits_table_range_size = { $cells }, { $columns }
edits_table_range_functions =
    { $count ->
        [one] { $count } functie
       *[other] { $count } functies
    }
edits_table_range_rows =
    { $count ->
        [one] { $count } rij
       *[other] { $count } rijen
    }
edits_table_range_columns =
    { $count ->
        [one] { $count } kolom
       *[other] { $count } kolommen
    }
edits_table_range_paste = Plakken…
edits_table_range_fillDown = Omlaag vullen
edits_table_range_clipboardClosed = Er is niets om te plakken dat deze pagina mag zien. Tik op het eerste veld en plak daar.
edits_table_tools = Gereedschap voor { $name }
edits_stepServo_title = Alle posities van { $servo }
edits_stepServo_now = Nu { $position }
edits_stepServo_nowRange = Nu { $lowest } tot { $highest }
edits_stepServo_by = Met (stappen)
edits_stepServo_step = Verstellen
edits_stepServo_which = Welke
edits_stepServo_all = Alle functies
edits_stepServo_from = Vanaf { $slot }
edits_stepServo_stops =
    { $count ->
        [one] { $steps }: { $what } stopt bij { $at }.
       *[other] { $steps }: { $what } stoppen bij { $at }.
    }
edits_shift_open = Verschuiven…
edits_shift_from =
    { $isLast ->
        [true] { $row }
       *[false] { $row } en alles erna
    }
edits_shift_by = Met (seconden)
edits_shift_earlier = Eerder
edits_shift_later = Later
edits_shift_moveDt = DT ook verschuiven
edits_shift_function = functie { $number }
edits_shift_functionRange = functies { $first } tot en met { $last }
edits_shift_functions = functies { $numbers }
edits_shift_moved =
    { $later ->
        [true] { $time }{" "}s later gezet
       *[false] { $time }{" "}s eerder gezet
    }
edits_pasting_asks = Deze namen zijn niet bekend. Kies wat ze betekenen:
edits_pasting_choose = Kiezen
edits_pasting_leaveOut = Weglaten
edits_pasting_table = Wat waarheen gaat
edits_pasting_lead =
    { $count ->
        [0] Dit wijzigt niets.
        [one] Dit wijzigt { $count } waarde.
       *[other] Dit wijzigt { $count } waarden.
    }
edits_pasting_reading = { $field }: “{ $text }” wordt gelezen als { $time }.
edits_pasting_problems = Dit kan niet geplakt worden:
edits_pasting_place = Rij { $row }, kolom { $column } van de gekopieerde tekst
edits_pasting_problem = { $place }: { $reason }
edits_pasting_problemOf = { $place }, “{ $text }”: { $reason }
edits_pasting_apply = Plakken
edits_presets_title = DT-voorkeuzes
edits_presets_use = DT { $time }
edits_presets_refused = Typ tijden zoals 20 s of 2:30, tot 10:55 min, hoogstens 24.
edits_fix = Op { $value } zetten
edits_fixOf = Op { $value } zetten: { $field }

## The library as files: export, import, and the reminder to export.

files_export_all = Alles exporteren…
files_export_one = Exporteren…
files_export_downloaded = “{ $name }” gaat naar je downloads: { $what }. Kijk of het daar staat.
files_export_without = zonder { $kind }
files_export_kinds_models = modellen
files_export_kinds_settings = programma’s
files_export_kinds_flights = vluchten
files_export_partly = “{ $name }” is niet volledig. Het bevat { $what }. Wat de browser nu niet kan lezen: { $missing }. Sluit andere tabbladen van deze pagina en exporteer opnieuw.
files_export_and = { $first } en { $next }
files_export_tooLarge = De bibliotheek is te groot voor één bestand. Exporteer de modellen een voor een.
files_export_failed = Het bestand kon niet gemaakt worden. Laad de pagina opnieuw en probeer het nog eens.
files_import_button = Importeren…
files_import_title = { $name } importeren
files_import_lead = Opgeslagen { $date }. Het bevat { $what }.
files_import_leadNothing = Opgeslagen { $date }. Het bevat niets.
files_import_ignored =
    { $count ->
        [one] { $count } item is van een nieuwere versie van deze pagina en wordt weggelaten.
       *[other] { $count } items zijn van een nieuwere versie van deze pagina en worden weggelaten.
    }
files_import_nothing = Dit alles heb je al.
files_import_differs = Wat verschilt
files_import_ways_newer = Het nieuwere nemen
files_import_ways_both = Beide behouden
files_import_itself = het model zelf
files_import_flightOf = vlucht van { $day }
files_import_wayText_newer = Wat hier nieuwer is, of dezelfde datum heeft, blijft.
files_import_wayText_both = Beide blijven. Wat uit het bestand komt, krijgt een nummer achter de naam.
files_import_unknownModel = Een model dat hier niet is
files_import_group_fresh = Nieuw: { $what }
files_import_group_same = Hetzelfde: { $what }
files_import_group_fileNewer = Nieuwer in het bestand: { $what }
files_import_group_deviceNewer = Niet nieuwer in het bestand: { $what }
files_import_group_fileName = { $file } (hier: { $here })
files_import_take =
    { $count ->
        [0] Niets te importeren
       *[other] { $count } importeren
    }
files_import_allStays = Niets in het bestand is nieuwer. Kies “{ files_import_ways_both }” om het toch te importeren.
files_import_done = Uit “{ $name }” geïmporteerd: { $what }.
files_import_undo = Import ongedaan maken
files_import_undone = De import is ongedaan gemaakt. Latere wijzigingen blijven.
files_refused_title = { $name } kan niet geïmporteerd worden
files_refused_nothing = Er is niets geïmporteerd.
files_refused_again = Exporteer het bestand opnieuw, of vraag de afzender om een nieuw.
files_refused_fault = Regel{"\u00a0"}{ $line }: { $found } gevonden.
files_refused_faultIn = Regel{"\u00a0"}{ $line }, { $place }: { $found } gevonden.
files_refused_wanted = Verwacht:
files_refused_place_entry =
    { $kind ->
        [models] Model “{ $name }”
        [settings] Programma “{ $name }”
       *[flights] Vlucht “{ $name }”
    }
files_refused_place_unnamed =
    { $kind ->
        [models] Model { $number } in het bestand
        [settings] Programma { $number } in het bestand
       *[flights] Vlucht { $number } in het bestand
    }
files_refused_place_function = functie { $number }
files_refused_damaged = Het bestand is beschadigd of niet volledig.
files_refused_files_too-large = Het bestand is te groot voor een bibliotheek.
files_refused_files_gone = Het bestand kon niet gelezen worden. Kies het opnieuw.
files_refused_files_several = Importeer één bestand tegelijk.
files_refused_format = Dit is geen bibliotheekbestand van Sidus Timer.
files_refused_newer = Een nieuwere versie van deze pagina heeft het gemaakt. Laad de pagina opnieuw als je online bent.
files_reminder =
    { $changes ->
        [one] { $changes } wijziging van de bibliotheek staat alleen op dit apparaat. Als je het verliest, brengt alleen een bestand die terug.
       *[other] { $changes } wijzigingen van de bibliotheek staan alleen op dit apparaat. Als je het verliest, brengt alleen een bestand ze terug.
    }

## For the time before the other sentences are loaded.

first_failed = De pagina is niet volledig. Is er een netwerk?
first_again = Opnieuw laden

## What a system shows of the installed page: public/manifest.webmanifest has the same in English.

manifest_description = Stelt Sidus-timers voor vrije vlucht in, F1Q, F1B en F1E: leest wat een timer bevat, neemt je wijzigingen, schrijft ze, leest ze terug en vergelijkt. Bewaart je modellen en programma’s op dit apparaat. Werkt zonder netwerk.
manifest_connect = Een timer verbinden
manifest_connectShort = Verbinden
manifest_connectWhat = De startpagina, met “Verbinden” bij de hand
manifest_library = Bibliotheek
manifest_libraryWhat = Modellen en hun programma’s
manifest_simulated = Gesimuleerde timer
manifest_simulatedWhat = De startpagina, met de gesimuleerde timers bij de hand
manifest_pictures_program = Het programma van een timer, met twee wijzigingen gemarkeerd
manifest_pictures_write = Wat schrijven zal wijzigen, voordat het gebeurt
manifest_pictures_programPhone = Het hele programma op een telefoon
manifest_pictures_writePhone = Wat schrijven zal wijzigen, op een telefoon

## The help inside the page.

guide_pages_checklist = Checklist
guide_pages_trouble = Problemen
guide_pages_words = Waarden
guide_pages_steps = Om te beginnen
guide_nav = Helppagina’s

## What a new pilot is told.

firstSteps_1 = Lezen: druk op “Verbinden”, wek de timer, houd de infraroodkop dichtbij. Lezen wijzigt niets en beweegt niets.
firstSteps_2 = Schrijven: typ nieuwe waarden, druk op “Schrijven”, bekijk elk verschil. “Geverifieerd” betekent: de timer is opnieuw gelezen en bevat wat je wilt.
firstSteps_3 = Vliegen: bovenaan de pagina staat welk geheugen voor de volgende vlucht geldt, en de DT ervan. De pagina heeft geen netwerk nodig, en niets verlaat dit apparaat.

## The values of a program, with unit and range.

values_function_text = Een fase van de vlucht: op zijn tijd gaat elke servo naar zijn positie. Om een functie over te slaan, geef je die de posities van de functie ervoor.
values_function_range = Meestal start, negen functies en DT.
values_time_text = Wanneer een functie begint, geteld vanaf de start. Typ 12,5 of 2:05. Bij F1B en F1E is niet bekend vanaf waar de timer telt.
values_time_range = Volgens de handleidingen. F1Q: 0,1 tot 99,9 s. F1B: 0,01 tot 9,99 s voor functies 1 en 2, daarna 0,1 tot 99,9 s. F1E: niet bekend.
values_after_text = De tijd sinds de functie ervoor. Alle latere functies schuiven mee, DT niet.
values_position_name = Positie
values_position_text = Waar een servo staat. De hoek van een stap hangt af van servo en stuurstang: probeer het op de testbank.
values_position_range = 0 tot 130 stappen.
values_motorStop_text = F1Q: wanneer de motor stopt, geteld vanaf de start. Er beweegt geen servo bij.
values_motorStop_range = Volgens de handleiding 0,1 tot 99,9 s, per 0,1 s.
values_dt_text = De thermiekrem: wanneer die het model naar beneden brengt, geteld vanaf de start. Rood als het korter is dan je grens.
values_dt_range = Volgens de handleiding 1 tot 720 s. Meer dan 10:55 min kan niet gestuurd worden.
values_idleThrottle_text = F1Q: waarschijnlijk hoe snel de motor draait terwijl de startschakelaar ingedrukt is.
values_idleThrottle_range = De pagina gaat uit van 0 tot 100. De eenheid is niet bekend.
values_memory_text = Een timer heeft meerdere geheugens, elk met een programma. Het gekozen geheugen geldt voor de volgende vlucht. Om een ander te bekijken, kiest de pagina het en gaat weer terug. Wordt dat onderbroken, dan zegt de pagina welk geheugen misschien voor de volgende vlucht geldt.
values_memory_range = Meestal vier, M1 tot M4. Oudere timers hebben er vijf.

## What a pilot checks before a flight.

checklist_lead = Vink elk punt af. De vinkjes gelden voor één vlucht en worden niet bewaard.
checklist_items_memory = Het juiste geheugen is gekozen voor de volgende vlucht.
checklist_items_dtTime = Ik heb de DT-tijd hardop gezegd.
checklist_items_surfaces = Vleugel, stabilo en richtingroer zitten stevig vast en staan zoals het moet.
checklist_items_battery = De accu is geladen en de stekker zit er helemaal in.
checklist_items_dtSeen = Ik heb de servo naar de DT-positie zien gaan.
checklist_items_radioDt = Ik heb de radio-DT geprobeerd, als die er is.
checklist_items_switch = Ik heb vijf keer op de startschakelaar gedrukt en hij sprong elke keer terug.
checklist_items_propeller = De propeller zit goed vast en draait vrij. Er staat niemand voor.
checklist_known_now = Volgende vlucht: { $memory }, DT{"\u00a0"}{ $dt }, gelezen { $time }.
checklist_known_onceAt = Zoals laatst gelezen, { $time }: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_once = Zoals laatst gelezen: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_not = Het is niet bekend wat { $memory } bevat. Lees dit geheugen voordat je vliegt.
checklist_known_nothing = Er is geen timer gelezen. Verbind er een om hier het geheugen voor de volgende vlucht en de DT ervan te zien.
checklist_known_unwritten =
    { $count ->
        [one] { $count } wijziging nog niet in de timer.
       *[other] { $count } wijzigingen nog niet in de timer.
    }
checklist_left =
    { $count ->
        [one] nog { $count } punt
       *[other] nog { $count } punten
    }
checklist_done = Alles afgevinkt. Goede vlucht.
checklist_again = Alle vinkjes wissen

## Problems as a pilot sees them, and what to do.

troubles_symptoms_noAnswer_title = De timer antwoordt niet
troubles_symptoms_noAdapter_title = De pagina vindt de adapter niet
troubles_symptoms_refused_title = De adapter gaat niet open
troubles_symptoms_wrongValues_title = De waarden zien er verkeerd uit
troubles_symptoms_wrongValues_steps_1 = Kijk bovenaan de pagina: welk geheugen zie je, en welk geldt voor de volgende vlucht?
troubles_symptoms_wrongValues_steps_2 = Druk op “{ program_read }”.
troubles_symptoms_wrongValues_steps_3 = Dalen de tijden van rij tot rij? Dan vraagt de pagina hoe ze te lezen zijn.
troubles_symptoms_wrongValues_steps_4 = Vergelijk bij F1B en F1E de tijden met het programmeerapparaat.
troubles_symptoms_cutOff_title = Het schrijven is onderbroken
troubles_symptoms_cutOff_steps_1 = Vlieg nog niet met dit model. Maak verbinding: de pagina leest de timer en biedt dan aan het schrijven af te maken of de oude waarden terug te schrijven.
troubles_symptoms_cutOff_steps_2 = Wat de timer daarvoor bevatte, staat bij “Geheugens”, “Back-ups”.
troubles_symptoms_noDt_title = DT gaat niet af, of op de verkeerde tijd
troubles_symptoms_noDt_steps_1 = Kijk bovenaan de pagina: daar staat welk geheugen voor de volgende vlucht geldt, en de DT ervan. Een ander geheugen heeft een andere DT.
troubles_symptoms_noDt_steps_2 = Springt de startschakelaar elke keer terug? Zolang hij ingedrukt is, beginnen de functies niet en gaat DT niet af.
troubles_symptoms_noDt_steps_3 = Is de accu geladen, en zit de stekker er helemaal in? Als de timer niet loopt, gaat DT niet af.
troubles_symptoms_noDt_steps_4 = Houd het model goed vast en druk in de weergave “{ views_names_bench }” op de rij DT. Gaat de servo naar de DT-positie, en laat hij los wat hij vasthoudt?
troubles_symptoms_noDt_steps_5 = Haal de propeller eraf en laat de timer tot het einde lopen. Vlieg niet voordat je de servo op de tijd van DT hebt zien bewegen.
troubles_symptoms_noMove_title = Een servo beweegt niet
troubles_symptoms_noMove_steps_1 = Houd het model vast en druk in de weergave “{ views_names_bench }” op de rij van de functie waarbij de servo moet bewegen. Beweegt er niets? Kijk naar stekker en accu. Beweegt hij daar wel, maar niet in de vlucht? Dan heeft hij dezelfde positie als in de functie ervoor.
troubles_symptoms_noMove_steps_2 = Gaat hij ergens anders heen dan de tabel zegt? Sommige timers bewaren een positie misschien alleen voor de functie waarbij de servo’s staan. De pagina biedt dan aan de servo’s tijdens het schrijven te bewegen.
troubles_symptoms_noMove_steps_3 = Bromt hij, of stopt hij te vroeg? Misschien blokkeert de stuurstang hem: probeer een kleinere beweging.
troubles_symptoms_noMotor_title = De motor start niet
troubles_symptoms_noMotor_steps_1 = Na een vlucht vergrendelt de timer de motor. Om hem te ontgrendelen, houd je het model vast en je handen weg van de propeller: die kan gaan draaien. Houd dan in de weergave “{ views_names_bench }” de knop “{ bench_unlock }” ingedrukt.
troubles_symptoms_noMotor_steps_2 = Is de startschakelaar teruggesprongen? Zolang hij ingedrukt is, draait de motor alleen stationair.
troubles_symptoms_noMotor_steps_3 = Is de motorstop laat genoeg? Bij 0,1 s stopt de motor zodra hij is gestart.
troubles_symptoms_noLibrary_title = Mijn modellen en programma’s zijn er niet
troubles_symptoms_noLibrary_steps_1 = Maak het zoekveld leeg en druk op “Archief”.
troubles_symptoms_noLibrary_steps_2 = Elke browser, elk profiel en elk adres heeft een eigen bibliotheek; een privévenster wist die.
troubles_symptoms_noLibrary_steps_3 = Op een ander apparaat, of als hij verloren is: “Importeren”, en het bestand van je laatste export.

## What to do, step by step, when a timer cannot be reached.

help_title = Wat te doen
help_steps_programs = Sluit andere tabbladen en programma’s die de adapter gebruiken, zoals Arduino IDE, PuTTY, een programma voor 3D-printers of een droneconfigurator.
help_steps_replug = Trek de adapter eruit, wacht vijf seconden en steek hem er weer in. Helpt dat niet, start de computer dan opnieuw op.
help_steps_cable = Sluit de adapter direct aan, zonder hub, en probeer een andere kabel. Veel USB-kabels laden alleen.
help_steps_windows = Windows: open Apparaatbeheer. Een geel teken bij de adapter betekent dat het stuurprogramma ontbreekt: ga online en voer Windows Update uit.
help_steps_mac = Mac: sta het accessoire toe als de Mac erom vraagt. Een oude macOS heeft het stuurprogramma van de fabrikant nodig.
help_steps_linux = Linux laat je de adapter misschien niet gebruiken. Voer dit uit, log dan uit en weer in.
help_steps_linux-container = De Linux van een Chromebook heeft de adapter misschien. Zet de adapter daar uit: Instellingen, Linux-ontwikkelomgeving, USB-apparaten beheren.
help_steps_android = Gebruik op Android { android }. { restWorks }
help_steps_bluetooth = Bluetooth: koppel de adapter in de instellingen van het systeem (code 1234 of 0000), houd hem aan en dichtbij, en zet Bluetooth uit op andere apparaten die hem gebruiken.
help_steps_firefox-finds = Firefox vindt geen Bluetooth-adapters, en helemaal geen als het uit de Ubuntu-winkel komt. Gebruik Chrome.
help_steps_firefox-reload = Firefox houdt een adapter vast die gefaald heeft. Laad deze pagina opnieuw. Wat je hebt getypt, blijft bewaard.
help_steps_switch = { link_stages_steps_switch }
help_steps_near = { link_stages_steps_near }
help_steps_battery = Is de accu van de timer geladen en aangesloten? Met een lege accu staat een timer in zijn DT-positie.
help_steps_restarts = Sommige adapters herstarten telkens als hun poort geopend wordt (DTR reset ze) en horen dan enkele seconden niets. Doet de jouwe dat, stel dan zijn baudrate in bij “Opties”, “{ ports_settings }”: dan wordt de poort maar één keer geopend. De pagina zelf laat DTR zoals de browser het zet.
help_steps_usual-settings = Open “Opties”, “{ ports_settings }” en druk op “{ ports_reset }”: dan vindt de pagina de baudrate zelf.
help_steps_report = Als het weer gebeurt: “Opties”, “Expert”, “Lijn”, “{ line_copyReport }”. Stuur het naar:
help_steps_address = Open dit adres in een tabblad:
help_page = Alle aanwijzingen, voor elk systeem

## For when the browser does not store, or give back, what it should.

keeping_title = Deze browser bewaart niet alles.
keeping_notKept = Wat je typt, back-ups en de aantekening van een onderbroken schrijfactie blijven alleen zolang deze pagina open is. Exporteer de bibliotheek. Sluit dan andere tabbladen van deze pagina, of maak ruimte op dit apparaat.
keeping_notKnown = De browser zegt niet of hij bewaart wat je doet. Ga ervan uit dat hij het niet bewaart, en exporteer de bibliotheek.
keeping_oneTab = Gebruik maar één tabblad van deze pagina.
keeping_emptied = De browser heeft gewist wat hij voor deze pagina bewaarde. Exporteer wat je nog ziet.
keeping_export = Bibliotheek exporteren…

## Stored data that cannot be read.

aside_title =
    { $count ->
        [one] 1 record kon niet gelezen worden. Het is opzijgezet, niet gewist.
       *[other] { $count } records konden niet gelezen worden. Ze zijn opzijgezet, niet gewist.
    }
aside_write = Daarbij is de aantekening van een onderbroken schrijfactie: lees de timer voordat je vliegt.
aside_save = In een bestand opslaan

## “2 models, 1 program”: only kinds that there are.

counted_models =
    { $count ->
        [one] { $count }{"\u00a0"}model
       *[other] { $count }{"\u00a0"}modellen
    }
counted_settings =
    { $count ->
        [one] { $count }{"\u00a0"}programma
       *[other] { $count }{"\u00a0"}programma’s
    }
counted_flights =
    { $count ->
        [one] { $count }{"\u00a0"}vlucht
       *[other] { $count }{"\u00a0"}vluchten
    }
counted_backups =
    { $count ->
        [one] { $count }{"\u00a0"}back-up
       *[other] { $count }{"\u00a0"}back-ups
    }

## What was deleted a moment ago.

removed = Gewist: { $what }.

## Deletes everything that this device keeps.

erase_open = Alles op dit apparaat wissen…
erase_lead = Dit wist alle modellen, programma’s, vluchten, back-ups, ongeschreven wijzigingen en opties van deze pagina uit deze browser. Het kan niet ongedaan gemaakt worden. Timers behouden wat ze bevatten.
erase_uncertain = Een schrijfactie is onderbroken, en het is niet bekend wat de betrokken timer bevat. Zonder de aantekening daarvan kan deze pagina je niet waarschuwen: lees de betrokken timer voordat je vliegt.
erase_start = Alles wissen
erase_running = Bezig met wissen
erase_failed = Niet alles kon gewist worden. Sluit andere tabbladen van deze pagina en probeer het opnieuw, of wis de gegevens ervan in de instellingen van de browser.

## For a page that is shown inside another page.

framed_title = Sidus Timer werkt alleen in een eigen tabblad: een andere pagina zou kunnen bedekken wat je van je timer ziet.
framed_open = Sidus Timer in een eigen tabblad openen

## What is known about the content of a timer, and what is not.

knowledge_title = Onzeker
knowledge_uncertain = Het is niet bekend wat { $memory } bevat: { $values }.
knowledge_noFly = Vlieg niet voordat dit gelezen is.
knowledge_since = Onderbroken schrijfactie, begonnen { $time }.
knowledge_thisMemory = het huidige geheugen
knowledge_memoryOf = { $memory } van { $timer }
knowledge_timer_here = de { $name } { $firmware }
knowledge_timer_simulated = de gesimuleerde { $name } { $firmware }
knowledge_otherTimer_here = een andere { $name } { $firmware }
knowledge_otherTimer_simulated = een andere gesimuleerde { $name } { $firmware }
knowledge_motorStop = motorstop
knowledge_either = { $name } is { $before } of { $goal }
knowledge_list =
    { $more ->
        [one] { $named }, en nog{"\u00a0"}{ $more }{"\u00a0"}waarde is onzeker
       *[other] { $named }, en nog{"\u00a0"}{ $more }{"\u00a0"}waarden zijn onzeker
    }
knowledge_and = { $first } en { $next }
knowledge_connect = Verbinden en lezen
knowledge_forget = Dit vergeten…
knowledge_forgetSure = Vergeet het alleen als je die timer elders hebt gelezen, of hem niet meer hebt.
knowledge_forgetNow = Nu vergeten
knowledge_verified = Zoals in de timer, geverifieerd { $time }
knowledge_readAt = Zoals in de timer, gelezen { $time }
knowledge_lastReadAt = Zoals laatst gelezen, { $time }
knowledge_lastRead = Zoals laatst gelezen
knowledge_ofSetting =
    { $changes ->
        [0] { $name }: opgeslagen
        [one] { $name }: { $changes } wijziging niet opgeslagen
       *[other] { $name }: { $changes } wijzigingen niet opgeslagen
    }
knowledge_changed = { $name }, gewijzigd
knowledge_ofModel = { $name } van { $model }
knowledge_made = Nieuw programma, nog in geen timer
knowledge_unknown = Niet bekend wat { $memory } bevat
knowledge_unfinished =
    { $count ->
        [one] { $count } veld heeft nog geen waarde
       *[other] { $count } velden hebben nog geen waarde
    }
knowledge_hints_now = Gemarkeerde velden verschillen van wat de timer bevat.
knowledge_hints_onceAt = Gemarkeerde velden verschillen van wat laatst gelezen is, { $time }.
knowledge_hints_once = Gemarkeerde velden verschillen van wat laatst gelezen is.
knowledge_marks_now = was { $value }
knowledge_marks_once = laatst gelezen { $value }
knowledge_notCertain = , nu onzeker
knowledge_held_now = Timer bevat
knowledge_held_once = Laatst gelezen

## Why a program of the library or from a link cannot be opened now.

obstacles_busy = Deze pagina leest, schrijft of zoekt een timer. Wacht tot dat klaar is.
obstacles_following = De servo’s volgen. Stop dat eerst.
obstacles_not-fitting = { notFitting }

## Models and their saved programs.

library_unread = De browser kan de bibliotheek nu niet lezen. Sluit andere tabbladen van deze pagina en probeer het opnieuw.
library_empty_title = Nog geen model
library_empty_lead = Een model bevat zijn programma’s, met namen en notities. Ze worden alleen op dit apparaat bewaard.
library_empty_hint = Maak een model, of lees een timer en sla zijn programma op.
library_search_label = Programma’s zoeken
library_search_nothing = Geen programma heeft al deze woorden.
library_models_title = Modellen
library_models_all = Alle modellen
library_models_make = Nieuw model…
library_models_settings =
    { $count ->
        [one] { $count } programma
       *[other] { $count } programma’s
    }
library_models_archive = Archief ({ $count })
library_models_archived = in archief
library_models_latest = Laatst gewijzigd
library_list_open = op het scherm
library_model_timerClass = Klasse
library_model_noClass = Niet opgegeven
library_model_facts = Over dit model
library_model_noSettings = Nog geen programma.
library_model_servos = Servo’s
library_model_servosUnknown = Sla eerst een programma van dit model op.
library_model_servoWay = { $low } tot { $high } stappen
library_model_archive = Archiveren
library_model_unarchive = Uit het archief halen
library_model_remove = Model wissen
library_model_withSettings =
    { $count ->
        [one] Het programma ervan wordt mee gewist. “Ongedaan maken” brengt beide terug.
       *[other] De { $count }{"\u00a0"}programma’s ervan worden mee gewist. “Ongedaan maken” brengt alles terug.
    }
library_setting_isOpen = Op het scherm: bekijken
library_setting_loadAgain =
    { $count ->
        [one] Opnieuw openen: { $count } waarde gaat terug
       *[other] Opnieuw openen: { $count } waarden gaan terug
    }
library_setting_tags = Trefwoorden, met komma’s ertussen
library_setting_from_typed = getypt
library_setting_from_timer = gelezen uit een timer
library_setting_from_simulated = gelezen uit een gesimuleerde timer
library_setting_from_backup = uit een back-up
library_setting_from_file = uit een bestand
library_setting_from_link = uit een link
library_setting_origin = { $source }, { $time }
library_setting_notShown = Het kon niet geopend worden. Probeer het opnieuw.
library_setting_gone = Het is niet meer in de bibliotheek.
library_save_open = Opslaan…
library_save_over = { $program } overschrijven
library_save_undo = Opslaan van { $name } terugnemen
library_save_crossing = Dit zijn waarden van { $from }. Onder { $to } opslaan.
library_save_asNew = Als nieuw opslaan…
library_save_taken = Er is al een programma { $program }. Typ een andere naam, of:
library_save_replace = Overschrijf het. De waarden ervan blijven als eerdere versie.
library_save_name =
    { $of ->
        [model] Naam van het model
       *[program] Naam van het programma
    }
library_save_namePlace = Bijvoorbeeld: fly-off, kalm
library_save_notSavable = Een veld heeft geen waarde. Verbeter het eerst.
library_save_state =
    { $changes ->
        [0] { $name }: opgeslagen
        [one] { $name }: { $changes } wijziging niet opgeslagen
       *[other] { $name }: { $changes } wijzigingen niet opgeslagen
    }
library_nameNeeded = Het heeft een naam nodig.

## The log of the line.

line_empty = Niets om te tonen.
line_unused = Nog niets op de lijn. Je kunt ook een opname laden en als timer afspelen.
line_all = Alles
line_out = Naar de timer
line_in = Van de timer
line_damaged = Beschadigd
line_request = { $name } · { $letters }
line_reply = { $name }, antwoord · { $letters }
line_echo = { $name }, echo · { $letters }
line_unknown = Onbekende letter { $letter }
line_names_GETTIMERS = Tijden lezen
line_names_SETTIMERS = Tijden schrijven
line_names_GETSERVOPOS = Posities lezen
line_names_SETSERVO = Positie schrijven
line_names_MOVETOFUNC = Servo’s bewegen
line_names_GETSWVER = Herkennen
line_names_UNLOCK = Motor ontgrendelen
line_names_JUMP2 = Sprong
line_names_GETMEMORY = Welk geheugen
line_names_SETMEMORY = Geheugen kiezen
line_names_GETLOWRPM = Stationair lezen
line_names_SETLOWRPM = Stationair schrijven
line_rejected_noise = Beschadigd: ruis
line_rejected_length = Beschadigd: onmogelijke lengte
line_rejected_terminator = Beschadigd: geen einde waar het hoort
line_rejected_checksum = Beschadigd: verkeerde controlesom
line_rejected_silence = Beschadigd: afgebroken
line_error_framing = Lijnfout: framing
line_error_parity = Lijnfout: pariteit
line_error_break = Lijnfout: break
line_error_overrun = Lijnfout: overloop, er gingen bytes verloren
line_error_other = Lijnfout van een andere soort
line_position = { $slot }, { $servo }: { $steps } stappen
line_motorStop = motorstop { $time }
line_reserved = gereserveerd { $time }
line_functions = functies { $times }
line_identity = { $name }, firmware { $firmware }, { $functions } en DT, { $memories }, { $servos }
line_memories =
    { $count ->
        [one] { $count } geheugen
       *[other] { $count } geheugens
    }
line_memoryUnsaid = Hij zegt niet welk.
line_idleThrottle = { $value }, eenheid onbekend
line_idleThrottleUnsaid = Hij geeft geen waarde.
line_acknowledged = Bevestigd.
line_unreadable_wrong-length = De inhoud is langer of korter dan het hoort.
line_unreadable_unknown-command = Het is niet bekend wat het betekent.
line_unreadable_unexpected-reply = Het antwoordt op een ander verzoek.
line_unreadable_bad-identity = Wat het over de timer zegt, kan niet kloppen.
line_unreadable_identity-needed = Het is te lezen zodra de timer heeft gezegd wat hij is.
line_unreadable_out-of-range = Een waarde erin kan niet kloppen.
line_unreadable_not-an-integer = { line_unreadable_out-of-range }
line_unreadable_wrong-count = { line_unreadable_out-of-range }
line_unreadable_wrong-type = { line_unreadable_out-of-range }
line_unreadable_unknown-word = De inhoud is niet te lezen.
line_unreadable_bad-capture = { line_unreadable_unknown-word }
line_unreadable_bad-file = { line_unreadable_unknown-word }
line_unreadable_bad-link = { line_unreadable_unknown-word }
line_unreadable_newer-version = { line_unreadable_unknown-word }
line_unreadable_too-large = { line_unreadable_unknown-word }
line_unreadable_duplicate = { line_unreadable_unknown-word }
line_goOn = Verder
line_came =
    { $number ->
        [one] Gepauzeerd. { $number } regel sindsdien.
       *[other] Gepauzeerd. { $number } regels sindsdien.
    }
line_clear = Leegmaken
line_unidentified = onbekend
line_load = Laden…
line_filter = Tonen
line_searchHint = naam of hex
line_counts_out = { $count } naar de timer
line_counts_in = { $count } van de timer
line_counts_damaged = { $count } beschadigd
line_counts_errors =
    { $count ->
        [one] { $count } lijnfout
       *[other] { $count } lijnfouten
    }
line_recording =
    { $entries ->
        [one] { $name }: een opname van { $entries } regel.
       *[other] { $name }: een opname van { $entries } regels.
    }
line_replay = Als timer afspelen
line_cannotReplay = De opname kan niet afgespeeld worden: de timer zegt nergens wat hij is.
line_back = Terug naar de echte lijn
line_noRecordingAt = Regel { $line }: een tijd in seconden, > of <, en bytes in hex verwacht.
line_noRecording = Dit bestand is geen opname.
line_send_title = Zelf een telegram sturen
line_send_lead = De pagina voegt lengte en controlesom toe.
line_send_bytes = Letter en gegevens, in hex
line_send_faults_hex = Typ twee hexcijfers voor elke byte, 0 tot 9 of A tot F.
line_send_faults_too-long = Een telegram bevat hoogstens 252 bytes.
line_send_preview = Gaat eruit als
line_send_send = Sturen…
line_send_confirmTitle = Dit telegram naar de timer sturen?
line_send_danger = Servo’s kunnen bewegen, de propeller kan gaan draaien, en wat de timer bevat kan veranderen. Daarna wordt de timer opnieuw gelezen.
line_send_confirm = Ja, één keer sturen
line_send_sending = Bezig met sturen
line_send_answered = Antwoord:
line_send_unanswered = Er kwam geen antwoord. Wat het telegram vroeg, kan toch gebeurd zijn.
line_copyReport = Rapport kopiëren

## From the ports to a timer that answers.

link_portNames_ftdi = FTDI-adapter
link_portNames_cp210x = CP210x-adapter (Silicon Labs)
link_portNames_ch340 = CH340-adapter (WCH)
link_portNames_pl2303 = PL2303-adapter (Prolific)
link_portNames_bluetooth = Bluetooth
link_portNames_usb = USB-adapter
link_portNames_other = Seriële poort
link_stages_choosing = Kies de adapter van de timer
link_stages_openingLong_title = Het openen van de adapter duurt lang
link_stages_openingLong_advice = Bluetooth: zet de adapter aan, dichtbij. Kabel: trek hem eruit en steek hem er weer in.
link_stages_asking = Vraagt met { $rate } baud.
link_stages_noAnswer = Al { $seconds } s geen antwoord. Deze pagina blijft vragen en gaat vanzelf verder.
link_stages_open = De adapter is open
link_stages_steps_switch = Wek de timer: druk kort op zijn schakelaar
link_stages_steps_near = Houd de infraroodkop op minder dan 20 cm, uit de zon
link_stages_steps_other = Zit de timer aan een andere adapter?
link_refused = De pagina blijft het 15 seconden proberen. Misschien heeft een ander programma de adapter.
link_heard_title = Er is iets te horen, maar geen timer antwoordt.
link_heard_advice = Wek de timer en houd de infraroodkop dichterbij, uit de zon, of kies een andere adapter.
link_slow_title = Een timer antwoordt, maar te langzaam.
link_slow_advice = Zijn bytes komen een voor een met { $rate } baud, met zulke lange pauzes dat geen antwoord op tijd compleet is. Deze pagina kan hem niet lezen. Probeer een andere adapter, of een kabel in plaats van Bluetooth.
link_itSaid = Wat er kwam: { $bytes } (“{ $text }”).
link_trySelectBare = Zonder juiste controlesom proberen
link_lost_title = De verbinding met de adapter is verloren.
link_lost_advice = Sluit hem aan, of breng hem dichterbij: de pagina gaat vanzelf verder. Wat je hebt getypt, blijft bewaard.
link_status_off = Niet verbonden
link_status_opening = Verbinden
link_status_searching = Timer zoeken
link_status_away = Verbinding verloren
link_status_closing = Verbreken

## The known ports, and how they are opened.

ports_title = Bekende adapters
ports_forget = Vergeten
ports_settings = Seriële instellingen
ports_settingsHint = Alleen voor een bijzondere adapter. De pagina vindt de baudrate zelf.
ports_rate = Baudrate
ports_findRate = Zoeken
ports_baud = { $rate } baud
ports_parity = Pariteit
ports_parities_none = Geen
ports_parities_even = Even
ports_parities_odd = Oneven
ports_stopBits = Stopbits
ports_dtr = DTR
ports_rts = RTS
ports_signals_leave = Zoals de browser het zet
ports_signals_on = Aan
ports_signals_off = Uit
ports_reset = Gewone instellingen

## What is known about the connected timer. Its numbers are in the report.

aboutTimer_title = Over deze timer
aboutTimer_damage = Schade gezien op de lijn
aboutTimer_crowd = Misschien is een andere timer of een programmeerapparaat in de straal. Sindsdien moeten twee lezingen overeenkomen.
aboutTimer_found = Wat hij anders deed
aboutTimer_nothingFound = Tot nu toe niets: hij heeft alles gedaan zoals gewoonlijk.
aboutTimer_quirkNames_timers-reply-66 = Hij antwoordt met de letter van een ander commando.
aboutTimer_quirkNames_unlock-reply-6a = { aboutTimer_quirkNames_timers-reply-66 }
aboutTimer_quirkNames_memory-unknown = Hij zegt niet welk geheugen het huidige is.
aboutTimer_quirkNames_memory-impossible = { aboutTimer_quirkNames_memory-unknown }
aboutTimer_quirkNames_bare-checksum = Hij antwoordt over stationair niet zoals gewoonlijk.
aboutTimer_quirkNames_times-big-endian = Zijn tijden dalen. Met de twee bytes van elke tijd verwisseld zouden ze stijgen.
aboutTimer_quirkNames_servo-first = Bij het schrijven van een positie neemt hij de servo voor de functie.
aboutTimer_quirkNames_servo-unanswered = Hij antwoordde niet toen een positie werd geschreven.
aboutTimer_quirkNames_times-rounded = Hij rondt tijden af.
aboutTimer_quirkNames_memories-from-one = Hij telt zijn geheugens vanaf 1.
aboutTimer_quirkNames_positions-unchanged = Hij bevestigde posities maar bewaarde ze niet.
aboutTimer_quirkNames_echo = De adapter stuurt terug wat hij krijgt.
aboutTimer_quirkNames_idle-throttle-unanswered = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_identity-unusual = Wat hij over zichzelf zegt, bevat bytes die niet bekend zijn.
aboutTimer_quirkNames_idle-throttle-malformed = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_replies-alike = Zijn antwoorden op sommige verzoeken zijn beschadigd, elk op dezelfde manier.
aboutTimer_assumed = Bekende afwijkingen
aboutTimer_assumedHint = Onthouden voor deze adapter en dit soort timer.
aboutTimer_forget = Bekende afwijkingen vergeten
aboutTimer_assumptions_bigEndianTimes = De twee bytes van elke tijd zijn verwisseld
aboutTimer_assumptions_servoFirst = { aboutTimer_quirkNames_servo-first }
aboutTimer_assumptions_memoriesFromOne = { aboutTimer_quirkNames_memories-from-one }
aboutTimer_assumptions_bareChecksumRequests = “{ line_names_SETMEMORY }” en “{ line_names_SETLOWRPM }” worden zonder juiste controlesom gestuurd
aboutTimer_assumptions_positionsNeedMove = Posities blijven alleen bewaard bij de functie waarbij de servo’s staan

## Which memory flies next, and what is known about the others.

nextFlight_badge = volgende vlucht
nextFlight_onScreen = Dit is { $memory }.
nextFlight_named = { $memory }, volgende vlucht
nextFlight_other = Volgende vlucht: { $memory }.
nextFlight_last = { $memory } was het huidige geheugen toen de timer voor het laatst antwoordde. Het geldt voor de volgende vlucht, tenzij iets anders dat heeft gewijzigd.
nextFlight_original = Toen je verbinding maakte, was het { $original }.
nextFlight_originalUnknown = Het is niet bekend welk het was toen je verbinding maakte.
nextFlight_unknown = Het is niet bekend welk geheugen voor de volgende vlucht geldt.
nextFlight_asked = { $memory } is het laatst gekozen.
nextFlight_back = Terug naar { $original }
nextFlight_leaving_title = Voordat je de verbinding verbreekt
nextFlight_leaving_back = Terug naar { $original } en verbreken
nextFlight_leaving_failed = De timer ging niet terug naar { $original }. Hij is nog verbonden.

## The last reading of a memory that is not current.

look_read = { $memory }, gelezen { $time }
look_notRead = { $memory } is niet gelezen
look_either = Ofwel
look_or = of
look_lead = Alleen om te bekijken. Volgende vlucht: { $current }.
look_edit = { $memory } bewerken
look_look = { $memory } bekijken
look_hint = Dit kiest { $memory }, leest het en gaat terug naar { $current }.
look_fly = { $memory } kiezen voor de vlucht
look_show = { $memory } tonen

## Jobs over several memories, and the backups.

memories_copy = { $from } naar { $to } kopiëren
memories_restore = Back-up terugzetten
memories_restoreAll = Alle { $count } terugzetten…
memories_plans_screen =
    { $keepsThrottle ->
        [true] { $to } zal de tijden en posities op het scherm bevatten. Van wat { $to } nu bevat, wordt eerst een back-up bewaard. Stationair blijft zoals het is.
       *[false] { $to } zal de tijden en posities op het scherm bevatten. Van wat { $to } nu bevat, wordt eerst een back-up bewaard.
    }
memories_plans_copy = { $to } zal de tijden en posities van { $from } bevatten, zoals net gelezen. Van wat { $to } nu bevat, wordt eerst een back-up bewaard.
memories_plans_restore = Dit schrijft in { $names } de back-up van { $time }. Van wat er nu staat, wordt eerst een back-up bewaard.
memories_atEnd = Aan het einde geldt { $current } weer voor de volgende vlucht.
memories_refused = In { $memory } kan niets geschreven worden: geen software kan deze waarden sturen.
memories_untouched = In { $memory } is niets geschreven.
memories_stopped = Wat nog niet geschreven was, is zoals het was.

## All memories of a timer at a glance.

overview_readAll = Alles lezen en bewaren
overview_copyTo = Kopiëren naar…
overview_compareWith = Met { $memory } vergelijken
overview_readAt = gelezen { $time }
overview_notCertain = Onzeker: een schrijfactie hierin is onderbroken. Getoond zoals voor die schrijfactie.
overview_edited = Getoond en gekopieerd zoals de timer het bevat, zonder je wijzigingen.
overview_same = Ze bevatten hetzelfde.
overview_differs =
    { $count ->
        [one] { $count } waarde verschilt.
       *[other] { $count } waarden verschillen.
    }

## How the timer writes its times: the question that no reading can answer.

byteOrder_title = De tijden van deze timer dalen van rij tot rij.
byteOrder_advice = Ze zouden stijgen als de twee bytes van elke tijd verwisseld waren. Vergelijk met wat je van de timer weet, en kies voordat je schrijft.
byteOrder_keep = Ze kloppen zoals getoond
byteOrder_exchange = Verwisselen en opnieuw lezen

## Why there is no connection.

connection_unsupported_title = { unsupportedHere_title }
connection_unsupported_advice = { unsupportedHere_advice }
connection_insecure_title = De browser staat hier geen seriële poorten toe.
connection_insecure_advice = { restWorks }
connection_policy_title = De server van deze pagina verbiedt seriële poorten.
connection_policy_advice = { restWorks }
connection_nothing-chosen_title = Er is geen adapter gekozen.
connection_nothing-chosen_advice = Druk op “Verbinden” en kies de adapter. Staat hij niet in de lijst, dan helpen de aanwijzingen hieronder.
connection_not-allowed_title = { connection_insecure_title }
connection_not-allowed_advice = Sta seriële poorten voor deze pagina toe in de instellingen van de browser en druk dan weer op “Verbinden”.
connection_busy_title = De adapter gaat niet open.
connection_busy_advice = Meestal heeft een ander programma of tabblad hem. Sluit dat en druk dan weer op “Verbinden”.
connection_bad-settings_title = De adapter neemt deze instellingen niet aan.
connection_bad-settings_advice = { help_steps_usual-settings }
connection_unplugged_title = De adapter is niet te bereiken.
connection_unplugged_advice = Trek hem eruit, steek hem er weer in en druk op “Verbinden”. Wat je hebt getypt, blijft bewaard.
connection_bad-reply_title = { link_heard_title }
connection_bad-reply_advice = { link_heard_advice }
connection_lost_title = { connection_unplugged_title }
connection_lost_advice = { connection_unplugged_advice }

## Why a job with the timer has ended.

timer_no-answer_title = De timer antwoordde niet.
timer_no-answer_advice = Druk kort op de schakelaar van de timer, houd de infraroodkop op minder dan 20 cm van de timer en probeer het opnieuw. Wat je hebt getypt, blijft bewaard.
timer_bad-reply_title = Het antwoord van de timer kan niet kloppen.
timer_bad-reply_advice = Probeer het opnieuw. Als het weer gebeurt: “Opties”, “Expert”, “Lijn”, “{ line_copyReport }”.
timer_unstable_title = Er is te veel storing op de lijn om die te vertrouwen.
timer_unstable_advice = Houd de infraroodkop dichterbij, uit de zon, en probeer het opnieuw.
timer_crowded_title = Misschien is er meer dan één timer in de straal.
timer_crowded_advice = Houd andere timers en programmeerapparaten uit de buurt en lees opnieuw.
timer_other-memory_title = Het huidige geheugen is niet dat op het scherm.
timer_other-memory_advice = Lees opnieuw voordat je schrijft.
timer_memory-unknown_title = Deze timer zegt niet welk geheugen het huidige is.
timer_memory-unknown_advice = Daarom kan deze pagina niet een ander geheugen bekijken en weer teruggaan. Het huidige kun je lezen en schrijven.
timer_memory-left_title = Misschien geldt nu een ander geheugen voor de volgende vlucht.
timer_memory-left_advice = Deze pagina kon niet teruggaan naar het geheugen dat het huidige was. Maak opnieuw verbinding en kies het juiste geheugen voor de volgende vlucht voordat je vliegt.
timer_other-timer_title = Dit is niet de timer die eerder antwoordde.
timer_other-timer_advice = De pagina leest hem. Bekijk wat hij bevat voordat je schrijft.
timer_stale_title = De timer bevat niet wat werd getoond.
timer_stale_advice = Er is niets geschreven. Bekijk wat schrijven nu zou wijzigen.
timer_changed_title = De timer bevat andere waarden dan eerder.
timer_changed_advice = Iets anders heeft hem gewijzigd, of dit is een andere timer. Je wijzigingen zijn bewaard: bekijk het verschil voordat je schrijft.
timer_stood-still_title = Deze pagina stond tijdens het werk stil.
timer_stood-still_advice = Daarna is er niets meer gestuurd: misschien is er inmiddels een andere timer. Lees opnieuw.
timer_too-slow_title = Deze timer antwoordt te langzaam.
timer_too-slow_advice = Zijn antwoorden duren meer dan 3 seconden, dus deze pagina kan niet zien welk antwoord bij welke vraag hoort. Daarna is er niets meer gestuurd. Probeer een andere adapter, of een kabel in plaats van Bluetooth.
timer_undecided_title = { byteOrder_title }
timer_undecided_advice = { byteOrder_advice }
timer_serious_title = De controle heeft iets ernstigs gevonden.
timer_serious_advice = { timer_stale_advice }
timer_busy_title = Iets op deze pagina of computer gebruikt de adapter.
timer_busy_advice = Er is niets gestuurd. Verbreek de verbinding en maak die opnieuw. Wat je hebt getypt, blijft bewaard.
timer_port-lost_title = { link_lost_title }
timer_port-lost_advice = { link_lost_advice }
timer_aborted_title = Gestopt.
timer_aborted_advice = Lees opnieuw om te zien wat de timer bevat.
timer_closed_title = Verbinding verbroken.
timer_closed_advice = Druk op “Verbinden” om verder te gaan. Wat je hebt getypt, blijft bewaard.

## Replies that are no noise, which is random.

alike_title = Elk antwoord op { $request } is op dezelfde manier beschadigd.
alike_advice = Dat is geen ruis: de timer of zijn adapter vormt deze antwoorden op een manier die niet bekend is. Zet “Expert” aan in de opties, open “Lijn” en druk op “{ line_copyReport }”. Stuur het rapport naar de beheerders (github.com/sidus-timer/sidus-timer/issues).
alike_part = Alleen om te bekijken: { $values }. Al het andere is niet bekend.

## Messages that are not about errors.

notes_back_title = Je wijzigingen zijn terug.
notes_back_advice = Vergelijk ze met wat de timer bevat, schrijf ze dan of maak ze ongedaan.
notes_back-uncertain_title = { notes_back_title }
notes_back-uncertain_advice = Het is niet bekend of ze geschreven zijn. Verbind de timer en lees hem voordat je vliegt.
notes_moved_title = { timer_changed_title }
notes_moved_advice = { timer_changed_advice }
notes_timer-moved_title = { timer_changed_title }
notes_timer-moved_advice = { timer_changed_advice }
notes_kept_title = Je wijzigingen zijn op dit apparaat bewaard.
notes_kept_advice = Ze passen niet bij wat nu is gelezen. Ze komen terug als je dat geheugen opnieuw leest; ook de startpagina noemt ze.
notes_other-kind_title = Er is nu een ander soort timer.
notes_other-kind_advice = { timer_other-timer_advice }
notes_write-completed_title = De onderbroken schrijfactie is volledig.
notes_write-completed_advice = De timer is opnieuw gelezen en bevat alles wat geschreven moest worden.
notes_nothing-written_title = { write_refused }
notes_nothing-written_advice = {""}
notes_not-backed-up_title = { write_unkept_title }
notes_not-backed-up_advice = { keeping_notKept }
notes_select-unanswered_title = De timer antwoordde niet toen een geheugen werd gekozen.
notes_select-unanswered_advice = Op andere verzoeken antwoordt hij. Probeer het opnieuw, of stuur het verzoek zonder juiste controlesom.
notes_backed-up_title = Alle geheugens zijn gelezen, en van elk is een back-up bewaard.
notes_backed-up_advice = {""}
notes_strays_title = { timer_crowded_title }
notes_strays_advice = { timer_crowded_advice }
notes_made-laid_title = De tabel toont je programma, niet wat de timer bevat.
notes_made-laid_advice = Er is niets geschreven. Wat verschilt, is gemarkeerd. “Ongedaan maken” toont wat de timer bevat.
notes_unexpected_title = Er ging iets mis op deze pagina.
notes_unexpected_advice = Daarna is er niets meer gestuurd. Laad de pagina opnieuw. Wat je hebt getypt, blijft bewaard.

## The flight of the program, and what the servos of the model move.

preview_title = Vluchtvoorbeeld
preview_guessed = Niet op schaal.
preview_nameServos = Servo’s benoemen…
preview_play = Afspelen
preview_speed = Snelheid
preview_time = Tijd van de vlucht
preview_launch = Start
preview_at = { $what } op { $time }
preview_sketch = Het model van opzij, en zijn richtingroer van boven
preview_motor_true = Stijgvlucht, motor draait
preview_motor_false = Glijvlucht, motor gestopt
preview_flies = In vlucht
preview_comesDown = DT: het model komt naar beneden
preview_duties_rudder = Richtingroer
preview_duties_tailplane = Stabilo
preview_duties_wing = Vleugel
preview_duties_release = Schijf of DT-lijn
preview_duties_other = Iets anders
preview_duties_none = Niet gebruikt
preview_naming_lead = Wat elke servo beweegt, en tussen welke stappen. Omhoog en omlaag gaan over de achterrand.
preview_naming_duty = { $servo } beweegt
preview_naming_name = Naam voor wat { $servo } beweegt
preview_naming_low = { $servo }, ene einde in stappen
preview_naming_high = { $servo }, andere einde in stappen
preview_naming_from = van
preview_naming_to = tot
preview_naming_sense = { $servo }, wat meer stappen doen
preview_naming_otherSense_false = meer stappen: omhoog
preview_naming_otherSense_true = meer stappen: omlaag
preview_naming_rudderSense_false = meer stappen: rechts
preview_naming_rudderSense_true = meer stappen: links

## The sheet of a program.

print_paper = Papier
print_what = Op het blad
print_parts_lines = Schrijflijnen
print_parts_code = QR-code
print_nothing = Kies programma’s uit de bibliotheek, of open er een.
print_choose = Programma’s op deze print: { $chosen }
print_clear = Alle weghalen
print_simulated = gesimuleerde timer
print_warnings = Bekijk dit voordat je vliegt
print_notes = Notities
print_codeHint = De camera van een telefoon opent dit programma, zonder de notitie ervan.
print_unfinished =
    { $count ->
        [one] { $count } veld heeft nog geen waarde: de laatste is geprint
       *[other] { $count } velden hebben nog geen waarde: de laatste is geprint
    }
print_printed = Geprint { $date }

## The model in the strip.

recognition_which = Welk model?
recognition_change = Model { $model }: zeg welk model het is

## A memory with the pilot's name for it: M2 “fly-off”.

memoryNames_named = { $memory } “{ $name }”

## What an earlier job left behind on a timer.

recovery_title = Een eerdere schrijfactie is onderbroken.
recovery_when = Schrijfactie in { $memory }, begonnen { $time }.
recovery_nothing =
    { $missing ->
        [one] De timer bevat wat hij daarvoor bevatte: er is niets geschreven, { $missing } wijziging ontbreekt.
       *[other] De timer bevat wat hij daarvoor bevatte: er is niets geschreven, { $missing } wijzigingen ontbreken.
    }
recovery_part =
    { $missing ->
        [one] De timer bevat { $values } van die schrijfactie; { $missing } waarde is nog zoals daarvoor.
       *[other] De timer bevat { $values } van die schrijfactie; { $missing } waarden zijn nog zoals daarvoor.
    }
recovery_foreign =
    { $count ->
        [one] { $count } waarde in de timer is niet de oude en ook niet van die schrijfactie. Is het een andere timer, of heeft iets anders de waarde gewijzigd?
       *[other] { $count } waarden in de timer zijn niet de oude en ook niet van die schrijfactie. Is het een andere timer, of heeft iets anders de waarden gewijzigd?
    }
recovery_sure = Deze pagina kan timers van dezelfde soort niet uit elkaar houden. Ga alleen verder als dit de timer van die schrijfactie is.
recovery_finish = Schrijven afmaken…
recovery_goBack = Oude waarden terugschrijven…
recovery_leave = Zo laten
recovery_otherTimer = Het is een andere timer
recovery_sameTimer = Het is dezelfde timer: tonen wat geschreven moest worden
recovery_compare = Vergelijken
recovery_before = Daarvoor
recovery_elsewhere = Een schrijfactie in { $memory } van een timer van deze soort is onderbroken. Lees { $memory } om te zien wat het bevat.
recovery_left = Het werk aan meerdere geheugens is onderbroken. Nu geldt { $current } voor de volgende vlucht. Daarvoor was het { $original }.
recovery_mayFly = Misschien geldt { $memory } voor de volgende vlucht: het kiezen ervan is onderbroken.
recovery_mayNotFly = Het werk aan meerdere geheugens is onderbroken. Misschien geldt een ander geheugen dan { $original } voor de volgende vlucht.
recovery_unknownMemory = een onbekend geheugen

## The backups.

backups_title = Back-ups
backups_empty = Voor elke schrijfactie bewaart deze pagina hier wat de timer bevat.
backups_reasons_write = voor het schrijven
backups_reasons_memories = alle geheugens

## How the page looks.

theme_title = Kleuren
theme_names_system = Systeem
theme_names_light = Licht
theme_names_dark = Donker
theme_names_sun = Zon

## The settings of the page.

settings_look = Uiterlijk
settings_expert = Expert: de lijn tonen
settings_expertHint = De lijn toont elke byte tussen deze pagina en de timer. De testbank biedt een sprong die niet gedocumenteerd is.
settings_kept = Wat dit apparaat bewaart

## A saved program as a link and a QR code, and back.

share_offer_lead = De link bevat het hele programma. Er gaat niets naar een server.
share_offer_link = Link
share_offer_copy = Link kopiëren
share_offer_scan = Richt de camera van het andere apparaat op deze code, of stuur de link.
share_offer_qr = QR-code van “{ $name }”
share_offer_cut = Het einde van de notitie past niet in de QR-code. De link bevat de hele notitie.
share_offer_tooLong = Te lang voor een QR-code. Stuur de link.
share_received_title = Een programma uit een link
share_received_lead = Tot nu toe toont deze pagina het alleen. Er wordt niets bewaard en niets in een timer geschreven.
share_received_known = De bibliotheek heeft deze waarden al: { $name }.
share_received_modelChoice = Bewaren onder
share_received_newModel = Nieuw model “{ $name }”
share_received_keep = In de bibliotheek bewaren
share_received_discard = Niet bewaren
share_received_unwritten = Wat je hebt getypt, blijft bewaard: “Ongedaan maken” of de startpagina brengt het terug.
share_damaged_title = Deze link is niet te lezen.
share_damaged_bad = Hij is afgebroken of beschadigd, of niet van deze pagina. Vraag er opnieuw om.
share_paste_title = Link plakken…
share_paste_lead = De camera van een telefoon opent een QR-code vanzelf. Hier kun je een link plakken.
share_paste_show = Tonen
share_paste_notLink = Dit is geen link naar een programma.

## A DT for trimming that is about to be flown. The page asks before the pilot disconnects, and at a contest round.

shortDt_held = DT van { $memory } is { $dt }.
shortDt_heldHere = DT is { $dt }.
shortDt_ask =
    { $remembered ->
        [true] Terugzetten op { $back }?
       *[false] Op { $back } zetten?
    }
shortDt_putBack =
    { $remembered ->
        [true] DT terugzetten op { $back }…
       *[false] DT op { $back } zetten…
    }
shortDt_disconnect = Zo verbreken: { $memory }, DT{"\u00a0"}{ $dt }
shortDt_disconnectHere = Zo verbreken: DT{"\u00a0"}{ $dt }
shortDt_blocked = Iets wat je hebt getypt, kan nog niet geschreven worden. Verbeter het voordat je DT terugzet.
shortDt_settings_limit = DT geldt als kort onder
shortDt_settings_hint = Een kortere DT is rood, en de pagina vraagt ernaar voordat je de verbinding verbreekt. Is de grens 0 s, dan vraagt de pagina het nooit.

## The start, before anything was read.

start_title = Stel je Sidus-timer in
start_lead = Lees wat hij bevat, wijzig het, schrijf het, en zie het geverifieerd. Niets verlaat dit apparaat.
start_adapter = Sluit de adapter aan
start_firefox = Firefox vraagt eerst om toestemming, en om de poort telkens als deze pagina wordt geladen.
start_android = Een telefoon verbindt via Bluetooth; een kabel vraagt Android { firstVersions_androidCable } en Chrome { firstVersions_android }.
start_readyOffline = Klaar zonder netwerk
start_install = Installeren
start_picture_example = Voorbeeld: een F1Q
start_picture_kept = Bewaard { $time }
start_models_title = Mijn modellen
start_models_none = Bewaar de programma’s van elk model, met notities.
start_models_programs =
    { $count ->
        [one] { $count } programma
       *[other] { $count } programma’s
    }
start_models_library = Bibliotheek openen
start_programs_title = Niet af
start_programs_made = { $timer }, nieuw
start_programs_changesOf = { $timer }, wijzigingen
start_programs_sure = Voorgoed wissen?
start_simulatedTitle = Geen timer bij je?
start_simulatedLead = Een gesimuleerde antwoordt als een echte, byte voor byte.
start_simulated = Gesimuleerde { $name }-timer proberen
start_backups =
    { $count ->
        [one] { $count } back-up, bewaard voor het schrijven. De laatste: { $last }.
       *[other] { $count } back-ups, bewaard voor het schrijven. De laatste: { $last }.
    }

## The dialog that makes a program without a timer.

newProgram_title = Nieuw programma…
newProgram_timerClass = Klasse
newProgram_functions = Functies, zonder start en DT
newProgram_servos = Servo’s
newProgram_from = Beginnen met
newProgram_beginnings_usual = Gewone tijden, servo’s in het midden
newProgram_beginnings_nothing = Alle tijden en posities 0
newProgram_caution = De posities van je model zijn hier niet bekend. Stel elke positie in voordat je schrijft.
newProgram_make = Programma maken

## The picture of a program over time.

timeline_title = Tijdlijn
timeline_compareBefore = voor het volgen
timeline_picture = Servoposities in de tijd
timeline_description = { $servos } en { $functions } in de tijd, DT op { $dt }. De tabel heeft alle waarden.
timeline_descriptionMotor = { $servos } en { $functions } in de tijd, DT op { $dt }, motorstop op { $motorStop }. De tabel heeft alle waarden.
timeline_functions =
    { $count ->
        [one] { $count } functie
       *[other] { $count } functies
    }
timeline_servos =
    { $count ->
        [one] { $count } servo
       *[other] { $count } servo’s
    }
timeline_keysToEdit = Pijlen gaan van markering naar markering en van servo naar servo, plus en min zoomen, 0 toont alles. Enter gaat naar de handvatten: pijlen verplaatsen ze, Escape gaat terug.
timeline_ask = Wijs of tik om af te lezen
timeline_finer = Fijner
timeline_steps =
    { $position ->
        [one] { $position } stap
       *[other] { $position } stappen
    }
timeline_stepsUnit = stappen
timeline_notKnown = Niet bekend: de tijden dalen
timeline_tools = Weergave
timeline_zoomIn = Inzoomen
timeline_zoomOut = Uitzoomen
timeline_fit = Alles tonen
timeline_passedOver = { $slot } wordt overgeslagen: { $next } komt op dezelfde tijd.
timeline_goesBack = { $next } komt eerder dan { $slot }. Het is niet bekend wat de timer in het gekleurde deel doet.

## A new version of the page.

update_ready = Er is een nieuwe versie klaar.
update_waits = Die start als je de verbinding verbreekt en alles gesloten en opgeslagen is.
update_take = Nu gebruiken
update_news = Wat er nieuw is

## The version of this page.

aboutPage_title = Deze pagina
aboutPage_version = Sidus Timer { $version }.
aboutPage_offline = De hele pagina staat op dit apparaat en werkt zonder netwerk.
aboutPage_notOffline = De pagina staat nog niet op dit apparaat: open die één keer met een netwerk.
aboutPage_licences = Licenties

## The views of the page and the links between them.

views_title = Weergaven
views_names_program = Programma
views_names_memories = Geheugens
views_names_bench = Testbank
views_names_library = Bibliotheek
views_names_line = Lijn
views_names_settings = Opties
views_names_print = Printen
views_names_help = Help
views_print = Printen…
views_share = Delen…
views_noTimer_memories = Verbind een timer om zijn geheugens te zien. De back-ups staan hieronder.
views_noTimer_bench = Verbind een timer om zijn servo’s te bewegen.

## The strip above every view: the timer, its memory, DT, motor stop, and what is known.

strip_panel = Geheugens en meer
strip_tried = { $count } geprobeerd
strip_notCertain = onzeker
strip_asRead = laatst gelezen
strip_notValid = ongeldig
strip_ofSetting =
    { $changes ->
        [0] opgeslagen
       *[other] { $changes } niet opgeslagen
    }
strip_made = in geen timer

## The list of commands.

palette_title = Opdrachten
palette_search = Typ wat je wilt doen
palette_nothing = Geen opdracht heet zo, of het kan nu niet.
palette_ctrl = Ctrl+{ $key }

## In place of a part of the page that is being loaded.

parts_coming = Laden
parts_failed = Een deel van deze pagina kon niet geladen worden.
parts_again = Opnieuw proberen

## Which model it is.

whichModel_recognition_same = Dit is { $model }, zoals gezien { $when }.
whichModel_recognition_like =
    { $count ->
        [one] Dit lijkt op { $model }, { $count } waarde verschilt. Is het { $model }?
       *[other] Dit lijkt op { $model }, { $count } waarden verschillen. Is het { $model }?
    }
whichModel_recognition_several = Dit kan { $models } zijn. Welk model is het?
whichModel_or = { $names } of { $last }
whichModel_others = nog { $count }
whichModel_recognition_unknown = Deze timer is hier niet bekend. Welk model is het?
whichModel_recognition_yes = Ja, { $model }
whichModel_recognition_choose = Kiezen…
whichModel_recognition_ok = OK
whichModel_recognition_dialog_title = Welk model is het?
whichModel_recognition_dialog_lead = Een timer kent zijn model niet. De pagina vergelijkt wat hij bevat met wat in elk model het laatst is gezien.
whichModel_recognition_dialog_said = Je hebt gezegd dat het { $model } is.
whichModel_recognition_dialog_moreMemories = Lees ook de andere geheugens: misschien onderscheiden die de modellen.
whichModel_recognition_dialog_none = Zo’n model van deze klasse is er niet.
whichModel_recognition_dialog_newModel = Een nieuw model
whichModel_recognition_dialog_keep = Als nieuw model bewaren
whichModel_memoryNames_label = Naam van { $memory }
whichModel_memoryNames_give = Benoemen
whichModel_crossing_title = Dit zijn waarden van { $from }, maar deze timer lijkt op die van { $to }.
whichModel_crossing_advice = Met de waarden van een ander model kun je dit model verliezen. Kijk naar het model dat voor je ligt.
whichModel_crossing_confirm = Waarden van { $from } in de timer van { $to } schrijven.
whichModel_crossing_memoryOf = { $memory } van { $model }

## A write, from the difference to the verdict.

write_title = In de timer schrijven
write_lead = Dit verandert er in { $memory }. Al het andere blijft zoals het is.
write_target = Schrijven in
write_nothing = Er is geen verschil. De timer wordt teruggelezen en vergeleken.
write_field = Waarde
write_from = Timer bevat
write_to = Zal bevatten
write_wasRead = Eerder gelezen
write_moved_model_title = Deze timer lijkt nu bij een ander model te horen.
write_moved_model_advice = Er is niets geschreven. Kijk naar de namen van de modellen.
write_moved_edits_title = Het programma is gewijzigd sinds dit werd getoond.
write_unkept_title = Dit apparaat kon geen back-up bewaren van wat de timer nu bevat.
write_unkept_advice = Dit geheugen is nog zoals het was. Verdergaan zonder back-up?
write_sideBySide = Waarden: { $names }
write_withoutCopy = Verder zonder back-up
write_safety = De propeller is eraf of het model wordt vastgehouden, en de timer staat niet op scherp.
write_acknowledge = Ik heb dit gelezen en wil het toch schrijven.
write_stillToTick = Nog aan te vinken: { $ticks }.
write_ticks_model = ander model
write_ticks_warnings = waarschuwingen
write_ticks_safety = propeller
write_move_why = Deze timer lijkt posities alleen te bewaren voor de functie waarbij zijn servo’s staan. Als de servo’s niet bewegen, bewaart hij deze posities waarschijnlijk niet.
write_move_label = De servo’s op elke functie zetten voordat de posities ervan worden geschreven.
write_move_hint = Houd het model goed vast, zonder iets in de weg van de servo’s.
write_move_notHeld_title = De timer bevestigde de posities maar bewaarde ze niet.
write_move_notHeld_advice = Deze timer bewaart ze waarschijnlijk alleen voor de functie waarbij zijn servo’s staan. Schrijf opnieuw en laat de servo’s daarbij op elke functie zetten.
write_move_again = Opnieuw schrijven…
write_start =
    { $count ->
        [0] Teruglezen en vergelijken
        [one] { $count } wijziging schrijven
       *[other] { $count } wijzigingen schrijven
    }
write_stages_read = Lezen
write_stages_write = Schrijven
write_stages_verify = Teruglezen
write_stages_repair = Verbeteren
write_stopping = Stopt na dit verzoek
write_stoppingBack = Stopt: eerst terug naar het geheugen van daarvoor
write_verified_title = Geverifieerd.
write_verified_advice = De timer is teruggelezen en bevat wat werd getoond.
write_verdict = { $memory } geverifieerd { $time }
write_asItIs = zoals het is
write_insteadOf = in plaats van { $value }
write_wanted = Te schrijven
write_readBack = Teruggelezen
write_differs_title = De timer nam niet elke waarde over.
write_differs_advice = De timer is teruggelezen. Hij bevat hier andere waarden:
write_unknown_title = Het is onzeker wat de timer bevat.
write_unknown_advice = De timer kon niet volledig teruggelezen worden. Lees opnieuw en schrijf dan wat nog verschilt. Je wijzigingen zijn bewaard.
write_cut = Het schrijven in { $memory } is onderbroken.
write_strayed_title = { $memory } werd tijdens het schrijven het huidige geheugen.
write_strayed_advice = Enkele van de waarden staan nu misschien in { $memory }. Lees het en kijk het helemaal na voordat je ermee vliegt.
write_refused = Er is niets geschreven.
write_status_differs = verschilt
write_status_unknown = niet bekend
write_putBack = door de timer zelf gewijzigd, teruggezet

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
       *[function] Functie { $slot }
    }
within_slot =
    { $kind ->
        [start] start
        [dt] DT
       *[function] functie { $slot }
    }
within_idleThrottle = stationair
slotShort =
    { $kind ->
        [start] Start
        [dt] DT
       *[function] { $slot }
    }
about = { $name }:
previous = Vorige
next = Volgende
pause = Pauze
less = { $what }: minder
moreOf = { $what }: meer
seconds = { $time }{" "}s
times_minutes = { $minutes }{" "}min
times_minutesSeconds = { $minutes }{" "}min { $seconds }{" "}s
times_units_s = s
times_units_min = min
times_figure = { $text } { $unit }
times_asSeconds = { $seconds }{" "}s, { $clock }
times_meaning = { $field }: wat bedoeld is
header_firmware = firmware { $firmware }
header_simulated = gesimuleerd
header_connect = Verbinden
header_choosePort = Andere adapter kiezen
header_closeProgram = Programma sluiten
header_disconnect = Verbreken
header_stop = Stop
program_tableCaption = Tijd en servoposities van elke functie
program_slot = Functie
program_time = Tijd
program_memory = Geheugen
program_memoryUnknown = Deze timer zegt niet welk geheugen het huidige is, dus het is niet bekend welk voor de volgende vlucht geldt.
program_memoryOpen = Het is niet bekend welk geheugen voor de volgende vlucht geldt. Kies er een voor die vlucht, of lees opnieuw.
program_dt = DT
program_motorStop = Motorstop
program_motor = Motor
program_idleThrottle = Stationair
program_throttle = Stationair
program_idleThrottleUnit = eenheid onbekend
program_reserved = gereserveerd { $time }
program_timeOf = { $slot }, tijd
program_motorStopTime = Motorstop, tijd
program_positionOf = { $slot }, { $servo }
program_shortDt = Korte DT
program_changes =
    { $count ->
        [one] { $count } wijziging
       *[other] { $count } wijzigingen
    }
program_undoAll = Alles ongedaan maken
program_read = Opnieuw lezen
program_connectAndWrite = Verbinden en schrijven…
program_write =
    { $count ->
        [0] Schrijven…
        [one] { $count } wijziging schrijven…
       *[other] { $count } wijzigingen schrijven…
    }
program_picture = Beeld
program_table = Tabel
program_blocked = Er kan nog niets geschreven worden. { $field }: { $why }
program_findings = Controle
program_noFindings = Niets ongewoons.
program_absolute = Getoond vanaf de start. Het is niet bekend of deze timer telt vanaf de start of vanaf de functie ervoor.
program_severity_error = Niet schrijfbaar
program_severity_serious = Ernstig
program_severity_warning = Ongewoon
program_reading = Timer lezen
program_selecting = Geheugen wisselen
otherTab_holdsSince = Sidus Timer is open in een ander tabblad, sinds { $since }.
otherTab_holds = Sidus Timer is open in een ander tabblad.
otherTab_takeOver = Hier gebruiken
otherTab_busy = Het andere tabblad werkt met de timer. Zodra dat klaar is, gaat het hier open.
otherTab_gone = Het andere tabblad antwoordt niet. Sluit het en laad deze pagina opnieuw.
disturbed = Antwoorden ontbreken of zijn beschadigd: is de timer wakker, en de infraroodkop dichtbij, uit de zon? Dit eindigt uiterlijk over { $seconds } s.
cancel = Annuleren
close = Sluiten
copy = Kopiëren
copied = Gekopieerd.
copyByHand = De browser laat deze pagina niet kopiëren. Kopieer het hier.
dismiss = Verbergen
done = Klaar
undo = Ongedaan maken
open = Openen
save = Opslaan
delete = Wissen
notNow = Niet nu
label_language = Taal
label_name = Naam
label_note = Notitie
label_model = Model
label_search = Zoeken
noModel = Geen model
more = En nog { $count }.
showMore = Nog { $count } tonen
of = { $button }: { $name }
notFitting = Het past niet bij de verbonden timer. Verbreek de verbinding om het te openen.
notKept = Deze browser heeft het niet bewaard: het gaat verloren als deze pagina wordt gesloten.

## The walk through the open questions of docs/protocol.md with a real timer.

settle_title = Met je timer uitzoeken
settle_lead = Niet alles is bekend over hoe deze timers praten. In vijftien minuten zoekt de jouwe uit wat open is. Elke waarde die geprobeerd wordt, wordt teruggezet. Houd het programmeerapparaat bij de hand.
settle_safe = De propeller is eraf of de motor is losgekoppeld, en de timer staat niet op scherp.
settle_danger = Er kan nu iets bewegen. Is de propeller eraf, of de motor losgekoppeld? Kijk nog een keer.
settle_blocked = Handel eerst de melding in de gekleurde balk bovenaan de pagina af, en behoud wat geprobeerd is of zet de oude waarden terug.
settle_readIt = Timer lezen
settle_which = Welke toont het programmeerapparaat?
settle_tryHint = Beweeg de servo’s met de knoppen van de pagina en wacht tot ze stilstaan. Probeer dan een positie: die wordt gewijzigd en binnen enkele seconden teruggezet. Let op de servo’s.
settle_tryIt = Een positie proberen
settle_moved = De oude positie is terug: de pagina heeft die teruggelezen. Bewoog er een servo toen de nieuwe werd geprobeerd?
settle_ask = Met vier nullen vragen
settle_unknown = Ik weet het niet
settle_send = Stuur het bestand met dit formulier
settle_names_order = De lage byte van een tijd komt eerst
settle_names_unit = Tijden zijn in honderdsten van een seconde
settle_names_count = Tijden tellen vanaf de start
settle_names_memories = Het eerste geheugen heeft nummer 0
settle_names_zeros = Vier nullen zijn genoeg
settle_names_layout = De functie komt voor de servo
settle_names_stores = Posities blijven bij elke functie bewaard
settle_names_moves = Een geschreven positie beweegt de servo ervan
settle_names_unlock = Letter die UNLOCK beantwoordt
settle_names_delay = Gewone duur tot een antwoord
settle_names_reserved = Gereserveerde tijd zoals gelezen
settle_yes = Ja
settle_no = Nee
settle_unnumbered = Er wordt geen nummer gegeven
settle_there = Alleen waar de servo’s staan
settle_delay = { $ms } ms
settle_open = Niet uitgezocht
