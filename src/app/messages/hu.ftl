### Az oldal minden mondata magyarul. Az angol eredeti az en.ftl, ugyanezekkel a nevekkel.
### Magyarul repülő versenyző nélkül készült fordítás: minden javítást szívesen fogadunk (docs/translating.md).
###
### A magyarban a szám után egyes szám áll, ezért a legtöbb mondatnak itt csak egy alakja van.

## Moving servos and motor from the page.

bench_slots = Mozgatás ide
bench_elsewhere = A szervók és a motor a következő repülés memóriájával működnek: { $memory }. Mozgatásukhoz jelenítse meg az { $memory } memóriát.
bench_trim = Trimmelés: { $slot }
bench_at = Szervók itt: { $slot }
bench_atNone = Nem tudni, hol állnak a szervók.
bench_moveMaybe = Nem jött válasz. A szervók ettől még elmozdulhattak. Nézze meg a modellt.
bench_unlocked = A motor zárolása fel van oldva. A légcsavar elindulhat.
bench_unlockMaybe = Nem jött válasz. Ettől még lehet, hogy a motor zárolása fel van oldva. Maradjon távol a légcsavartól.
bench_jumped = Az időzítő nyugtázta az ugrást.
bench_here = itt a szervók
bench_waits = Beírásra vár.
bench_bring = Szervók ide: { $slot }
bench_follow = A szervók követik az állásokat
bench_followHint = Az oldal először kiolvassa az időzítőt, és biztonsági másolatot készít. Utána minden állás, amelyet abban a sorban módosít, ahol a szervók állnak, azonnal bekerül az időzítőbe, és a szervója elmozdul.
bench_followingNow = Követés: ha abban a sorban módosít egy állást, ahol a szervók állnak, az azonnal bekerül az időzítőbe.
bench_stopFollowing = Követés vége
bench_ended_over = A szervók már nem követik az állásokat.
bench_ended_memory = A szervók már nem követik az állásokat: másik memória az aktuális, vagy lehet az.
bench_ended_strayed = Követés közben másik memória lett az aktuális. Lehet, hogy az állások egy része abba került: nézze át az egész memóriát, mielőtt repül vele.
bench_ended_unlike = A szervók már nem követik az állásokat: az időzítő nem azt tette, amit nyugtázott.
bench_ended_failed = A szervók már nem követik az állásokat: az időzítő nem válaszolt.
bench_notTaken = { $field }: az időzítőben { $held } van, nem { $wanted }.
bench_beside =
    { $more ->
        [0] Ezenkívül megváltozott: { $named }.
       *[other] Ezenkívül megváltozott: { $named }; és még { $more } érték.
    }
bench_triedHere =
    { $more ->
        [0] Kipróbálva: { $named }.
       *[other] Kipróbálva: { $named }; és még { $more } állás.
    }
bench_triedAndWaiting =
    { $waiting ->
        [0] { $tried } kipróbálva az időzítőben
       *[other] { $tried } kipróbálva az időzítőben, { $waiting } beírásra vár
    }
bench_triedIn = Állásokat próbáltak ki itt: { $memory }.
bench_decide = Megtartja, amit kipróbált, vagy visszaállítja, ami előtte az időzítőben volt?
bench_keep = Megtartás
bench_putBack = Visszaállítás…
bench_unlock = UNLOCK: tartsa nyomva
bench_unlockHold = Tartsa tovább
bench_unlockHint = A légcsavar elindulhat. Fogja a modellt, a kezét tartsa távol a légcsavartól, majd nyomja meg és tartsa nyomva a gombot.
bench_experimental = Kísérleti
bench_jumpHint = A korai DT utáni funkcióra ugrik. Pontos hatása nincs dokumentálva: a szervók elmozdulhatnak.
bench_jump = Ugrás…
bench_jumpSure = Ugrás küldése most

## The log of flights.

flights_title = Repülések
flights_empty_title = Még nincs repülés a naplóban.
flights_empty_advice = Olvasson ki vagy írjon be egy időzítőt, majd nyomja meg: „{ flights_flying_button }”.
flights_failed = A böngésző most nem tudja olvasni a könyvtárat. Zárja be az oldal többi lapját, és próbálja újra.
flights_flying_button = Ezzel repülök
flights_flying_purpose = Naplóba veszi a repülést azzal, ami az időzítőben van.
flights_flying_logged = Repülés naplózva: { $time }
flights_flying_fillIn = Kitöltés
flights_flying_again = Újra ezzel
flights_row_round = { $round }. forduló
flights_row_wind = { $wind } m/s
flights_row_temperature = { $degrees } °C
flights_row_noResult = nincs eredmény
flights_row_changed = { $values } változott
flights_row_otherTimer = másik időzítő
flights_totals_flights = { $count } repülés
flights_totals_best = legjobb { $time }
flights_totals_average = átlag { $time }
flights_filter_of = Repülések: { $name }
flights_filter_clear = Mind
flights_form_title = Repülés
flights_form_result = Eredmény
flights_form_resultHint = Másodperc, vagy perc így: 2:58.
flights_form_readAs = { $time }, { $seconds } s
flights_form_propose = Feljegyzés: { $facts }
flights_form_full = Teljes forduló, 180 s
flights_form_round = Forduló
flights_form_flyOff = Fly-off
flights_form_wind = Szél
flights_form_windUnit = m/s
flights_form_temperature = Hőmérséklet
flights_form_temperatureUnit = °C
flights_form_when = Dátum, hely, modell
flights_form_date = Dátum és idő
flights_form_noOffset = A mező időzónája nem ismert: ez ennek az eszköznek az ideje.
flights_form_place = Hely
flights_form_flown = Mivel repült
flights_form_open = Program megnyitása
flights_form_unreadable_not-a-number = Nem szám.
flights_form_unreadable_not-a-time = Nem idő: írjon másodpercet, például 178, vagy percet, például 2:58.
flights_form_unreadable_too-fine = { unreadable_too-fine }
flights_form_range = { $min } és { $max } { $unit } között.
flights_form_shortDt = Ezen a repülésen a DT { $dt } volt.
flights_score_open = Eredménylap
flights_score_maximum = A fordulók maximuma
flights_score_none = Maximum nélkül minden eredmény teljes egészében számít.
flights_score_maximumOf = Maximum: { $round }
flights_score_counted = Beszámít (s)
flights_score_notCounted = nem számít
flights_score_count = Számítson
flights_score_noRound = nincs forduló
flights_score_total = Összesen
flights_score_copy = Másolás szövegként
flights_csv_save = Mentés táblázatként (CSV)
flights_csv_columns_date = Dátum
flights_csv_columns_time = Idő
flights_csv_columns_zone = Időzóna
flights_csv_columns_place = Hely
flights_csv_columns_model = Modell
flights_csv_columns_setting = Program
flights_csv_columns_timerClass = Időzítő osztálya
flights_csv_columns_memory = Memória
flights_csv_columns_dt = DT (s)
flights_csv_columns_motorStop = Motorleállítás (s)
flights_csv_columns_wind = Szél (m/s)
flights_csv_columns_temperature = Hőmérséklet (°C)
flights_csv_columns_round = Forduló
flights_csv_columns_result = Eredmény (s)
flights_csv_columns_maximum = Maximum (s)
flights_csv_columns_note = Megjegyzés
flights_section_all = Minden repülése

## Values that are unusual, or cannot be written.

findings_time-not-whole = { unreadable_not-a-whole-number }
findings_time-out-of-range = { $min } és { $max } között kell lennie.
findings_position-not-whole = { unreadable_not-a-whole-number }
findings_position-out-of-range = { $min } és { $max } között kell lennie.
findings_throttle-not-whole = { unreadable_not-a-whole-number }
findings_throttle-out-of-range = { $min } és { $max } között kell lennie.
findings_position-as-read = A kiolvasott érték { $value }, az utolsó lépés ({ $max }) fölött. Így marad, ha nem módosítja.
findings_time-falls = Ez korábbra esik, mint a fölötte lévő funkció ({ $previous }).
findings_time-repeats = Ugyanaz az idő, mint a fölötte lévő funkcióé: { $previous }.
findings_position-never-reached = Ugyanaz az idő, mint a fölötte lévő funkcióé: { $previous }. A fölötte lévő funkció állásait a szervók soha nem érik el.
findings_motor-stop-after-dt = A motor a DT ({ $dt }) után áll le: a modell járó motorral jön le.
findings_motor-run-long = A motor tovább jár, mint az F1Q határa: { $limit }.
findings_time-outside-manual = A kézikönyv szerint { $min } és { $max } közötti lehet.
findings_time-too-fine = A kézikönyv szerint { $step } a lépésköz: az időzítő kerekíthet.
findings_dt-short = Rövidebb, mint { $limit }.
findings_dt-moves-nothing = DT-kor egy szervó sem mozdul: az időzítő nem hozza le a modellt.
findings_throttle-unusual = { $limit } fölött szokatlan. A mértékegység nem ismert.
findings_class-unknown = Ismeretlen osztály: „{ $timerClass }”. A szabályai nem lettek megvizsgálva.

## Why a text in a field is no value.

unreadable_empty = Üres: gépeljen be egy értéket.
unreadable_not-a-time = Nem idő: írjon másodpercet, például 12,5, vagy percet, például 2:05.
unreadable_too-fine = Századmásodpercnél finomabb.
unreadable_not-a-whole-number = Egész számnak kell lennie.
unreadable_ambiguous = Ez többféleképpen érthető: válasszon egyet.

## For a page that cannot reach a timer here.

restWorks = A kapcsolaton kívül itt is minden működik.

## What an Android phone needs.

firstVersions_android = 148
firstVersions_androidBluetooth = 138
firstVersions_lastBluetoothOnly = 147
firstVersions_androidCable = 17
android = Chrome { firstVersions_android } vagy újabb ({ firstVersions_androidBluetooth }–{ firstVersions_lastBluetoothOnly } csak Bluetooth-on); kábelhez Android { firstVersions_androidCable } kell

## For every browser about which nothing more is known. docs/connection.md names the first versions.

unsupportedHere_title = Ez a böngésző nem éri el az időzítőt.
unsupportedHere_advice = Számítógépen friss Chrome, Edge, Opera vagy Firefox kell, telefonon Chrome Androidon. { restWorks }

## Replaces the sentence above where the browser's name tells more.

unsupported_brave_title = A Brave csak akkor éri el az időzítőt, ha engedélyezi.
unsupported_brave_advice = Nyissa meg ezt: brave://flags/#brave-web-serial-api, állítsa Enabled értékre, és nyomja meg a Relaunch gombot. { restWorks }
unsupported_ios_title = iPhone-on és iPaden egyetlen böngésző sem éri el az időzítőt.
unsupported_ios_advice = Használjon számítógépet, vagy Chrome-ot egy androidos telefonon. { restWorks }
unsupported_android_title = { unsupportedHere_title }
unsupported_android_advice = Androidon ez kell: { android }. { restWorks }

## What a saved program held before it was saved over.

versions_title = Korábbi változatok
versions_until = Eddig:{"\u00a0"}{ $when }
versions_changed =
    { $more ->
        [0] utána { $change }
       *[other] utána { $change } és még { $more }
    }
versions_otherLayout = utána másik időzítő értékei
versions_same = A mentett programban most ez van.
versions_goBack = Vissza erre

## Two programs side by side.

compare_title = Összevetés
compare_open = Összevetés…
compare_second = ezzel
compare_screen = A képernyőn
compare_timer = Időzítő, { $memory }
compare_groups_now = Most
compare_groups_settings = Mentett programok
compare_setting = { $model } · { $name }
compare_backup = { $memory } · { $when }
compare_backupOf = { $model } · { $memory } · { $when }
compare_nothing = Ezen az eszközön nincs más program ilyen osztállyal és felépítéssel.
compare_take = Átvétel
compare_takeOf = Átvétel: { $value }, { $field }
compare_takeHint = Az átvétel egy értéket a képernyőn lévő programba másol.

## How a backup differs from what its timer holds.

modelBackups_same = mint az időzítőben: { $when }
modelBackups_differs = { $count } érték eltér az időzítőtől: { $when }
modelBackups_now = most


## Undo, redo, and edits of many fields at once.

edits_redoButton = Újra
edits_undo = Visszavonás: { $step }
edits_redo = Újra: { $step }
edits_steps_change = { $what } módosítása
edits_steps_shift = eltolás innen: { $what }, { $by }
edits_steps_step-servo = { $what }: { $steps }
edits_steps_step-servo-from = { $what }: { $steps }, innen: { $from }
edits_steps_paste = { $count } beillesztése
edits_steps_fill = { $count } kitöltése lefelé
edits_steps_revert-all = minden visszaállítása
edits_steps_open = megnyitás: { $what }
edits_steps_keep-tried = a kipróbált állások megtartása
edits_opened = „{ $name }”
edits_openedUnnamed = másik program
edits_refused_start = A startnak nincs módosítható ideje.
edits_refused_later-out-of-range = Egy későbbi funkció nem maradna { $min } és { $max } között.
edits_refused_unreadable = Egy szöveg, amely nem érték, útban van. Előbb javítsa ki.
edits_refused_interval-disagrees = Ez az időköz nem illik a két sor idejéhez.
edits_refused_no-place = A programban nincs ilyen hely.
edits_refused_twice = Ez a hely kétszer szerepel, különböző értékekkel.
edits_refused_too-large = A táblázat túl nagy: legfeljebb { $cells } cella olvasható be. A többi kimaradt.
edits_beforeLaunch = Ez a start előtt lenne.
edits_nothingDone = Semmi nem változott.
edits_cells = { $count } érték
edits_change = { $field }: { $from } → { $to }
edits_field_putBack = Visszaállítás: { $field }
edits_field_putBackTo = { $field } visszaállítása: { $figure }
edits_sheet_title = Billentyűk: { $field }
edits_sheet_erase = Az utolsó számjegy törlése
edits_sheet_putBack = Visszaállítás
edits_sheet_selectRange = Tartomány
edits_sheet_goTo = Ugrás ide: { $name }
edits_table_explain = Mit jelentenek az értékek
edits_table_interval = Időköz
edits_table_countedFrom = innen: { $row }
edits_table_switch = Idő vagy időköz
edits_table_intervalOf = { $slot }, időköz
edits_table_range_title = Kijelölt tartomány
edits_table_range_pick = Most érintsen meg egy másik cellát.
edits_table_range_size = { $cells }, { $columns }
edits_table_range_functions = { $count } funkció
edits_table_range_rows = { $count } sor
edits_table_range_columns = { $count } oszlop
edits_table_range_paste = Beillesztés…
edits_table_range_fillDown = Kitöltés le
edits_table_range_clipboardClosed = Nincs beilleszthető tartalom, amelyet ez az oldal láthatna. Érintse meg az első mezőt, és oda illesszen be.
edits_table_tools = Eszközök: { $name }
edits_stepServo_title = Minden állás: { $servo }
edits_stepServo_now = Most { $position }
edits_stepServo_nowRange = Most { $lowest } és { $highest } között
edits_stepServo_by = Mennyivel, lépésben
edits_stepServo_step = Léptetés
edits_stepServo_which = Melyik
edits_stepServo_all = Minden funkció
edits_stepServo_from = Innen kezdve: { $slot }
edits_stepServo_stops = { $steps }: { $what } itt megáll: { $at }.
edits_shift_open = Eltolás…
edits_shift_from =
    { $isLast ->
        [true] { $row }
       *[false] { $row } és minden utána
    }
edits_shift_by = Mennyivel, másodpercben
edits_shift_earlier = Korábbra
edits_shift_later = Későbbre
edits_shift_moveDt = A DT is
edits_shift_function = { $number }. funkció
edits_shift_functionRange = { $first }–{ $last }. funkció
edits_shift_functions = { $numbers }. funkció
edits_shift_moved =
    { $later ->
        [true] Későbbre tolva: { $time }{" "}s
       *[false] Korábbra tolva: { $time }{" "}s
    }
edits_pasting_asks = Ezek a nevek nem ismertek. Adja meg, mit jelentenek:
edits_pasting_choose = Válasszon
edits_pasting_leaveOut = Kihagyás
edits_pasting_table = Mi hová kerül
edits_pasting_lead =
    { $count ->
        [0] Ez semmit nem módosít.
       *[other] Ez { $count } értéket módosít.
    }
edits_pasting_reading = { $field }: „{ $text }” így értve: { $time }.
edits_pasting_problems = Ez nem illeszthető be:
edits_pasting_place = A másolt szöveg { $row }. sora, { $column }. oszlopa
edits_pasting_problem = { $place }: { $reason }
edits_pasting_problemOf = { $place }, „{ $text }”: { $reason }
edits_pasting_apply = Beillesztés
edits_presets_title = DT-gombok
edits_presets_use = DT { $time }
edits_presets_refused = Ilyen időket írjon: 20 s vagy 2:30, egyenként legfeljebb 10:55 min, összesen legfeljebb 24.
edits_fix = Legyen { $value }
edits_fixOf = Legyen { $value }: { $field }

## The library as files: export, import, and the reminder to export.

files_export_all = Minden exportálása…
files_export_one = Exportálás…
files_export_downloaded = „{ $name }” a letöltések közé kerül: { $what }. Nézze meg, hogy ott van-e.
files_export_without = ezek nélkül: { $kind }
files_export_kinds_models = modellek
files_export_kinds_settings = programok
files_export_kinds_flights = repülések
files_export_partly = „{ $name }” nem teljes. Ez van benne: { $what }. A böngésző most nem tudja olvasni ezt: { $missing }. Zárja be az oldal többi lapját, és exportáljon újra.
files_export_and = { $first } és { $next }
files_export_tooLarge = A könyvtár túl nagy egy fájlhoz. Exportálja a modelleket egyenként.
files_export_failed = A fájl nem készült el. Töltse be újra az oldalt, és próbálja meg még egyszer.
files_import_button = Importálás…
files_import_title = Importálás: { $name }
files_import_lead = Mentve: { $date }. Ez van benne: { $what }.
files_import_leadNothing = Mentve: { $date }. Nincs benne semmi.
files_import_ignored = { $count } bejegyzés az oldal újabb változatából való, és kimarad.
files_import_nothing = Mindez már megvan.
files_import_differs = Ami eltér
files_import_ways_newer = Az újabb maradjon
files_import_ways_both = Mindkettő maradjon
files_import_itself = maga a modell
files_import_flightOf = repülés: { $day }
files_import_wayText_newer = Ami itt újabb vagy azonos dátumú, az marad.
files_import_wayText_both = Mindkettő marad. A fájlból jövő neve után szám áll.
files_import_unknownModel = Modell, amely itt nincs meg
files_import_group_fresh = Új: { $what }
files_import_group_same = Ugyanaz: { $what }
files_import_group_fileNewer = A fájlban újabb: { $what }
files_import_group_deviceNewer = A fájlban nem újabb: { $what }
files_import_group_fileName = { $file } (itt: { $here })
files_import_take =
    { $count ->
        [0] Nincs mit importálni
       *[other] Importálás: { $count }
    }
files_import_allStays = A fájlban semmi nem újabb. Ha mégis importálni szeretné, válassza ezt: „{ files_import_ways_both }”.
files_import_done = Importálva ebből: „{ $name }”: { $what }.
files_import_undo = Importálás visszavonása
files_import_undone = Az importálás vissza van vonva. A későbbi módosítások maradnak.
files_refused_title = Nem importálható: { $name }
files_refused_nothing = Semmi nem lett importálva.
files_refused_again = Exportálja újra a fájlt, vagy kérjen újat a küldőjétől.
files_refused_fault = { $line }.{"\u00a0"}sor: talált: { $found }.
files_refused_faultIn = { $line }.{"\u00a0"}sor, { $place }: talált: { $found }.
files_refused_wanted = Várt:
files_refused_place_entry =
    { $kind ->
        [models] „{ $name }” modell
        [settings] „{ $name }” program
       *[flights] „{ $name }” repülés
    }
files_refused_place_unnamed =
    { $kind ->
        [models] a fájl { $number }. modellje
        [settings] a fájl { $number }. programja
       *[flights] a fájl { $number }. repülése
    }
files_refused_place_function = { $number }. funkció
files_refused_damaged = A fájl sérült vagy nem teljes.
files_refused_files_too-large = A fájl túl nagy ahhoz, hogy könyvtár legyen.
files_refused_files_gone = A fájlt nem sikerült beolvasni. Válassza ki újra.
files_refused_files_several = Egyszerre egy fájlt importáljon.
files_refused_format = Ez nem a Sidus Timer könyvtárfájlja.
files_refused_newer = Az oldal újabb változata készítette. Töltse be újra az oldalt, amikor van hálózat.
files_reminder = A könyvtár { $changes } módosítása csak ezen az eszközön van meg. Ha az eszköz elvész, csak fájlból hozható vissza.

## For the time before the other sentences are loaded.

first_failed = Az oldal nem teljes. Van hálózat?
first_again = Betöltés újra

## What a system shows of the installed page: public/manifest.webmanifest has the same in English.

manifest_description = Sidus F1Q, F1B és F1E időzítőket állít be szabadonrepülő modellekhez: kiolvassa, mi van az időzítőben, átveszi az Ön módosításait, beírja, visszaolvassa és összeveti őket. A modelleket és a programokat ezen az eszközön őrzi. Hálózat nélkül is működik.
manifest_connect = Kapcsolódás időzítőhöz
manifest_connectShort = Kapcsolódás
manifest_connectWhat = A kezdőlap, innen lehet kapcsolódni
manifest_library = Könyvtár
manifest_libraryWhat = Modellek és programjaik
manifest_simulated = Szimulált időzítő
manifest_simulatedWhat = A kezdőlap a szimulált időzítőkkel
manifest_pictures_program = Egy időzítő programja két megjelölt módosítással
manifest_pictures_write = Mit módosít egy írás, még a beírás előtt
manifest_pictures_programPhone = A teljes program telefonon
manifest_pictures_writePhone = Mit módosít egy írás, telefonon

## The help inside the page.

guide_pages_checklist = Ellenőrzőlista
guide_pages_trouble = Hibák
guide_pages_words = Értékek
guide_pages_steps = Első lépések
guide_nav = Súgóoldalak

## What a new pilot is told.

firstSteps_1 = Kiolvasás: nyomja meg a Kapcsolódás gombot, ébressze fel az időzítőt, és tartsa közel az infravörös fejet. A kiolvasás semmit nem módosít és semmit nem mozdít meg.
firstSteps_2 = Írás: gépelje be az új értékeket, nyomja meg az Írás gombot, és nézzen meg minden eltérést. Az „Igazolva” azt jelenti: az időzítő újra ki lett olvasva, és az van benne, amit Ön akar.
firstSteps_3 = Repülés: az oldal tetején látszik, melyik memóriával lesz a következő repülés, és mennyi a DT-je. Az oldalnak nem kell hálózat, és semmi nem hagyja el ezt az eszközt.

## The values of a program, with unit and range.

values_function_text = A repülés egy szakasza: a megadott időben minden szervó a saját állásába megy. Kihagyáshoz adja meg az előző funkció állásait.
values_function_range = Általában start, kilenc funkció és DT.
values_time_text = Mikor kezdődik egy funkció, a starttól számítva. Így írható: 12,5 vagy 2:05. F1B és F1E esetén nem tudni, honnan számol az időzítő.
values_time_range = A kézikönyvek szerint. F1Q: 0,1–99,9 s. F1B: 0,01–9,99 s az 1. és 2. funkciónál, utána 0,1–99,9 s. F1E: nem ismert.
values_after_text = Az előző funkció óta eltelt idő. Minden későbbi funkció vele mozog, a DT nem.
values_position_name = Állás
values_position_text = Hol áll egy szervó. Egy lépés szöge a szervótól és a rudazattól függ: próbálja ki a „{ views_names_bench }” nézetben.
values_position_range = 0–130 lépés.
values_motorStop_text = F1Q: mikor áll le a motor, a starttól számítva. Vele egy szervó sem mozdul.
values_motorStop_range = A kézikönyv szerint 0,1–99,9 s, 0,1 s lépésekben.
values_dt_text = A termikfék (DT): mikor hozza le a modellt, a starttól számítva. Piros, ha rövidebb az Ön határánál.
values_dt_range = A kézikönyv szerint 1–720 s. 10:55 min fölött nem küldhető el.
values_idleThrottle_text = F1Q: valószínűleg az, hogy milyen gyorsan forog a motor, amíg a startkapcsolót nyomva tartják.
values_idleThrottle_range = Az oldal feltevése: 0–100. A mértékegység nem ismert.
values_memory_text = Az időzítőben több memória van, mindegyikben egy program. A következő repülés a kiválasztottal lesz. Egy másik megtekintése kiválasztja azt, majd visszatér; ha ez megszakad, az oldal megmondja, melyikkel lehet a következő repülés.
values_memory_range = Általában négy, M1–M4. A régebbi időzítőkben öt van.

## What a pilot checks before a flight.

checklist_lead = Pipáljon ki minden pontot. A pipák egy repülésre szólnak, és nem őrződnek meg.
checklist_items_memory = A következő repüléshez a megfelelő memória van kiválasztva.
checklist_items_dtTime = Hangosan kimondtam a DT idejét.
checklist_items_surfaces = A szárny, a vezérsík és az oldalkormány szilárdan ül, és úgy áll, ahogy kell.
checklist_items_battery = Az akkumulátor fel van töltve, és a dugója teljesen be van dugva.
checklist_items_dtSeen = Láttam, hogy a szervó a DT-állásba megy.
checklist_items_radioDt = Kipróbáltam a rádiós DT-t, ha van.
checklist_items_switch = Ötször megnyomtam a startkapcsolót, és mindannyiszor visszaugrott.
checklist_items_propeller = A légcsavar szilárdan rögzítve van, és szabadon forog. Senki nincs előtte.
checklist_known_now = Következő repülés: { $memory }, DT{"\u00a0"}{ $dt }, kiolvasva { $time }.
checklist_known_onceAt = A legutóbbi kiolvasás szerint ({ $time }): { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_once = A legutóbbi kiolvasás szerint: { $memory }, DT{"\u00a0"}{ $dt }.
checklist_known_not = Nem tudni, mit tartalmaz az { $memory }. Repülés előtt olvassa ki.
checklist_known_nothing = Még egy időzítő sincs kiolvasva. Kapcsolódjon, hogy itt lássa a következő repülés memóriáját és annak DT-jét.
checklist_known_unwritten = { $count } módosítás még nincs az időzítőben.
checklist_left = Még { $count } pont
checklist_done = Minden kipipálva. Jó repülést.
checklist_again = Minden pipa törlése

## Problems as a pilot sees them, and what to do.

troubles_symptoms_noAnswer_title = Az időzítő nem válaszol
troubles_symptoms_noAdapter_title = Az oldal nem találja az adaptert
troubles_symptoms_refused_title = Az adapter nem nyílik meg
troubles_symptoms_wrongValues_title = Az értékek hibásnak tűnnek
troubles_symptoms_wrongValues_steps_1 = Nézze meg az oldal tetején: melyik memória látszik, és melyikkel lesz a következő repülés?
troubles_symptoms_wrongValues_steps_2 = Nyomja meg: „{ program_read }”.
troubles_symptoms_wrongValues_steps_3 = Csökkennek az idők sorról sorra? Az oldal ekkor megkérdezi, hogyan olvassa őket.
troubles_symptoms_wrongValues_steps_4 = F1B és F1E esetén hasonlítsa össze az időket a kézi programozóval.
troubles_symptoms_cutOff_title = Az írás megszakadt
troubles_symptoms_cutOff_steps_1 = Ezzel a modellel még ne repüljön. Kapcsolódjon: az oldal kiolvassa az időzítőt, majd felajánlja az írás befejezését vagy a régi értékek visszaírását.
troubles_symptoms_cutOff_steps_2 = Ami előtte az időzítőben volt, itt található: „{ views_names_memories }”, „{ backups_title }”.
troubles_symptoms_noDt_title = Nem jön a DT, vagy rossz időben jön
troubles_symptoms_noDt_steps_1 = Nézzen az oldal tetejére: ott áll, melyik memóriával lesz a következő repülés, és mennyi a DT-je. Másik memóriának más a DT-je.
troubles_symptoms_noDt_steps_2 = Minden alkalommal visszaugrik a startkapcsoló? Amíg nyomva van, a lefutás nem indul el, és DT sem jön.
troubles_symptoms_noDt_steps_3 = Fel van töltve az akkumulátor, és teljesen be van dugva a dugója? Ha az időzítő nem jár, DT sem jön.
troubles_symptoms_noDt_steps_4 = Fogja biztosan a modellt, és nyomja meg a DT sorát a „{ views_names_bench }” nézetben. Beáll a szervó a DT-állásba, és elengedi, amit tart?
troubles_symptoms_noDt_steps_5 = Vegye le a légcsavart, és hagyja végigfutni az időzítőt. Ne repüljön, amíg nem látta, hogy a szervó a DT idején elmozdul.
troubles_symptoms_noMove_title = Egy szervó nem mozdul
troubles_symptoms_noMove_steps_1 = Fogja a modellt, és nyomja meg a „{ views_names_bench }” nézetben annak a funkciónak a sorát, amelynél a szervónak mozdulnia kell. Semmi nem mozdul? Nézze meg a dugót és az akkumulátort. Ott mozdul, de repülés közben nem? Ugyanaz az állása, mint az előző funkcióban.
troubles_symptoms_noMove_steps_2 = Máshová megy, mint ami a táblázatban áll? Lehet, hogy egyes időzítők csak annál a funkciónál tárolják az állást, ahol a szervók állnak. Az oldal ekkor felajánlja, hogy írás közben mozgatja a szervókat.
troubles_symptoms_noMove_steps_3 = Zúg, vagy túl korán megáll? A rudazat akadályozhatja: próbáljon kisebb mozgást.
troubles_symptoms_noMotor_title = Nem indul a motor
troubles_symptoms_noMotor_steps_1 = Repülés után az időzítő zárolja a motort. A feloldáshoz fogja a modellt, és a kezét tartsa távol a légcsavartól: elindulhat. Ezután a „{ views_names_bench }” nézetben tartsa nyomva ezt a gombot: „{ bench_unlock }”.
troubles_symptoms_noMotor_steps_2 = Visszaugrott a startkapcsoló? Amíg nyomva van, a motor csak alapjáraton jár.
troubles_symptoms_noMotor_steps_3 = Nincs túl korán a motorleállítás? 0,1 s esetén a motor leáll, amint elindult.
troubles_symptoms_noLibrary_title = Nincsenek itt a modelljeim és a programjaim
troubles_symptoms_noLibrary_steps_1 = Ürítse ki a keresőmezőt, és nyomja meg az Archívum gombot.
troubles_symptoms_noLibrary_steps_2 = Minden böngészőnek, profilnak és címnek saját könyvtára van; a privát ablak törli a magáét.
troubles_symptoms_noLibrary_steps_3 = Másik eszközön, vagy ha elveszett: Importálás, a legutóbbi exportálás fájljával.

## What to do, step by step, when a timer cannot be reached.

help_title = Mi a teendő
help_steps_programs = Zárjon be minden más lapot és programot, amely az adaptert használja, például Arduino IDE, PuTTY, 3D-nyomtató programja vagy drónkonfiguráló.
help_steps_replug = Húzza ki az adaptert, várjon öt másodpercet, és dugja be újra. Ha ez nem segít, indítsa újra a számítógépet.
help_steps_cable = Dugja be az adaptert közvetlenül, elosztó nélkül, és próbáljon másik kábelt. Sok USB-kábel csak tölt.
help_steps_windows = Windows: nyissa meg az Eszközkezelőt. Ha az adapteren sárga jel van, hiányzik az illesztőprogramja: csatlakozzon az internethez, és futtassa a Windows Update-et.
help_steps_mac = Mac: engedélyezze a kiegészítőt, amikor a Mac megkérdezi. Régi macOS-hez a gyártó illesztőprogramja kell.
help_steps_linux = Lehet, hogy a Linux nem engedi használni az adaptert. Futtassa ezt, majd jelentkezzen ki és be.
help_steps_linux-container = Lehet, hogy a Chromebook Linuxa foglalta le az adaptert. Kapcsolja ki az adaptert a Beállításokban, itt: Linuxos fejlesztői környezet, USB-eszközök kezelése.
help_steps_android = Androidon ez kell: { android }. { restWorks }
help_steps_bluetooth = Bluetooth: párosítsa az adaptert a rendszer beállításaiban (kód: 1234 vagy 0000), hagyja bekapcsolva a közelben, és kapcsolja ki a Bluetooth-t a többi eszközön, amely használja.
help_steps_firefox-finds = A Firefox nem talál Bluetooth-adaptert, és az Ubuntu áruházából telepítve semmilyet sem. Használjon Chrome-ot.
help_steps_firefox-reload = A Firefox megtartja a hibára futott adaptert. Töltse be újra ezt az oldalt. Amit begépelt, megmarad.
help_steps_switch = { link_stages_steps_switch }
help_steps_near = { link_stages_steps_near }
help_steps_battery = Fel van töltve és be van dugva az időzítő akkumulátora? Lemerült akkumulátorral az időzítő a DT-állásban áll.
help_steps_restarts = Van adapter, amely újraindul, valahányszor megnyitják a portját (a DTR nullázza), és utána néhány másodpercig semmit sem hall. Ha az Öné ilyen, állítsa be a sebességét itt: Beállítások, „{ ports_settings }”. Így a port csak egyszer nyílik meg. Maga az oldal úgy hagyja a DTR-t, ahogy a böngésző beállítja.
help_steps_usual-settings = Nyissa meg: Beállítások, „{ ports_settings }”, és nyomja meg: „{ ports_reset }”. Az oldal ezután magától megtalálja a sebességet.
help_steps_report = Ha újra előfordul: Beállítások, Szakértő, Vonal, „{ line_copyReport }”. Ide küldje:
help_steps_address = Nyissa meg ezt a címet egy lapon:
help_page = Minden lépés, minden rendszerhez

## For when the browser does not store, or give back, what it should.

keeping_title = Ez a böngésző nem őriz meg mindent.
keeping_notKept = Amit begépel, a biztonsági másolatok és a megszakadt írás feljegyzése csak addig maradnak meg, amíg ez az oldal nyitva van. Exportálja a könyvtárat. Utána zárja be az oldal többi lapját, vagy szabadítson fel helyet ezen az eszközön.
keeping_notKnown = A böngésző nem mondja meg, hogy megőrzi-e, amit Ön csinál. Vegye úgy, hogy nem, és exportálja a könyvtárat.
keeping_oneTab = Ezt az oldalt csak egy lapon használja.
keeping_emptied = A böngésző törölte, amit ennek az oldalnak megőrzött. Exportálja, amit még lát.
keeping_export = Könyvtár exportálása…

## Stored data that cannot be read.

aside_title =
    { $count ->
        [one] 1 bejegyzést nem sikerült beolvasni. Félre van téve, nincs törölve.
       *[other] { $count } bejegyzést nem sikerült beolvasni. Félre vannak téve, nincsenek törölve.
    }
aside_write = Köztük van egy megszakadt írás feljegyzése: repülés előtt olvassa ki az időzítőt.
aside_save = Mentés fájlba

## “2 models, 1 program”: only kinds that there are.

counted_models = { $count }{"\u00a0"}modell
counted_settings = { $count }{"\u00a0"}program
counted_flights = { $count }{"\u00a0"}repülés
counted_backups = { $count }{"\u00a0"}biztonsági másolat

## What was deleted a moment ago.

removed = Törölve: { $what }.

## Deletes everything that this device keeps.

erase_open = Minden törlése ezen az eszközön…
erase_lead = Ez minden modellt, programot, repülést, biztonsági másolatot, be nem írt módosítást és az oldalon tett minden választást töröl ebből a böngészőből. Nem vonható vissza. Az időzítők tartalma megmarad.
erase_uncertain = Egy írás megszakadt, és nem tudni, mit tartalmaz az az időzítő. Annak az írásnak a feljegyzése nélkül ez az oldal nem tudja figyelmeztetni Önt: repülés előtt olvassa ki azt az időzítőt.
erase_start = Minden törlése
erase_running = Törlés
erase_failed = Nem sikerült mindent törölni. Zárja be az oldal többi lapját, és próbálja újra, vagy törölje az adatait a böngésző beállításaiban.

## For a page that is shown inside another page.

framed_title = A Sidus Timer csak saját lapon működik: egy másik oldal eltakarhatná, amit az időzítőjéből lát.
framed_open = Sidus Timer megnyitása saját lapon

## What is known about the content of a timer, and what is not.

knowledge_title = Bizonytalan
knowledge_uncertain = Nem tudni, mit tartalmaz az { $memory } – { $values }.
knowledge_noFly = Ne repüljön, amíg nem olvasta ki.
knowledge_since = Megszakadt írás, kezdete: { $time }.
knowledge_thisMemory = aktuális memória
knowledge_memoryOf = { $memory } ({ $timer })
knowledge_timer_here = { $name } { $firmware }
knowledge_timer_simulated = szimulált { $name } { $firmware }
knowledge_otherTimer_here = másik { $name } { $firmware }
knowledge_otherTimer_simulated = másik szimulált { $name } { $firmware }
knowledge_motorStop = motorleállítás
knowledge_either = { $name }: { $before } vagy { $goal }
knowledge_list = { $named }; és még { $more }{"\u00a0"}érték bizonytalan
knowledge_and = { $first }; { $next }
knowledge_connect = Kapcsolódás és kiolvasás
knowledge_forget = Elfelejtés…
knowledge_forgetSure = Csak akkor felejtse el, ha máshol kiolvasta azt az időzítőt, vagy már nincs meg.
knowledge_forgetNow = Elfelejtés most
knowledge_verified = Mint az időzítőben, igazolva { $time }
knowledge_readAt = Mint az időzítőben, kiolvasva { $time }
knowledge_lastReadAt = A legutóbbi kiolvasás szerint, { $time }
knowledge_lastRead = A legutóbbi kiolvasás szerint
knowledge_ofSetting =
    { $changes ->
        [0] { $name }: mentve
       *[other] { $name }: { $changes } módosítás nincs mentve
    }
knowledge_changed = { $name }, módosítva
knowledge_ofModel = { $name } ({ $model })
knowledge_made = Új program, még nincs időzítőben
knowledge_unknown = Nem tudni, mit tartalmaz az { $memory }
knowledge_unfinished = { $count } mezőnek még nincs értéke
knowledge_hints_now = A megjelölt mezők eltérnek attól, ami az időzítőben van.
knowledge_hints_onceAt = A megjelölt mezők eltérnek a legutóbbi kiolvasástól ({ $time }).
knowledge_hints_once = A megjelölt mezők eltérnek a legutóbbi kiolvasástól.
knowledge_marks_now = volt: { $value }
knowledge_marks_once = utolsó kiolvasás: { $value }
knowledge_notCertain = , most bizonytalan
knowledge_held_now = Időzítőben
knowledge_held_once = Legutóbb kiolvasva

## Why a program of the library or from a link cannot be opened now.

obstacles_busy = Az oldal éppen olvas, ír vagy időzítőt keres. Várja meg, amíg végez.
obstacles_following = A szervók követik az állásokat. Előbb állítsa le a követést.
obstacles_not-fitting = { notFitting }

## Models and their saved programs.

library_unread = A böngésző most nem tudja olvasni a könyvtárat. Zárja be az oldal többi lapját, és próbálja újra.
library_empty_title = Még nincs modell
library_empty_lead = Egy modellhez a programjai tartoznak, névvel és megjegyzéssel. Csak ezen az eszközön őrződnek meg.
library_empty_hint = Hozzon létre egy modellt, vagy olvasson ki egy időzítőt, és mentse a programját.
library_search_label = Programok keresése
library_search_nothing = Egyik programban sincs meg mindegyik szó.
library_models_title = Modellek
library_models_all = Minden modell
library_models_make = Új modell…
library_models_settings = { $count } program
library_models_archive = Archívum ({ $count })
library_models_archived = archivált
library_models_latest = Utolsó módosítás
library_list_open = a képernyőn
library_model_timerClass = Osztály
library_model_noClass = Nincs megadva
library_model_facts = A modellről
library_model_noSettings = Még nincs program.
library_model_servos = Szervók
library_model_servosUnknown = Előbb mentse a modell egy programját.
library_model_servoWay = { $low }–{ $high } lépés
library_model_archive = Archiválás
library_model_unarchive = Kivétel az archívumból
library_model_remove = Modell törlése
library_model_withSettings =
    { $count ->
        [one] A programja vele együtt törlődik. A visszavonás mindkettőt visszahozza.
       *[other] { $count }{"\u00a0"}programja vele együtt törlődik. A visszavonás mindet visszahozza.
    }
library_setting_isOpen = A képernyőn van: megnézés
library_setting_loadAgain = Megnyitás újra: { $count } érték visszaáll
library_setting_tags = Címkék, vesszővel elválasztva
library_setting_from_typed = begépelve
library_setting_from_timer = időzítőből kiolvasva
library_setting_from_simulated = szimulált időzítőből kiolvasva
library_setting_from_backup = biztonsági másolatból
library_setting_from_file = fájlból
library_setting_from_link = linkből
library_setting_origin = { $source }, { $time }
library_setting_notShown = Nem sikerült megnyitni. Próbálja újra.
library_setting_gone = Már nincs a könyvtárban.
library_save_open = Mentés…
library_save_over = Mentés, felülírva: { $program }
library_save_undo = Mentés visszavonása: { $name }
library_save_crossing = Ezek { $from } értékei. Mentés ide: { $to }.
library_save_asNew = Mentés újként…
library_save_taken = Már van ilyen program: { $program }. Írjon másik nevet, vagy:
library_save_replace = Mentés a helyére. A mostani értékei korábbi változatként megmaradnak.
library_save_name =
    { $of ->
        [program] A program neve
       *[model] A modell neve
    }
library_save_namePlace = Például: fly-off, szélcsend
library_save_notSavable = Egy mezőnek nincs értéke. Előbb javítsa ki.
library_save_state =
    { $changes ->
        [0] { $name }: mentve
       *[other] { $name }: { $changes } módosítás nincs mentve
    }
library_nameNeeded = Nevet kell adni neki.

## The log of the line.

line_empty = Nincs mit mutatni.
line_unused = A vonalon még nem volt semmi. Felvételt is betölthet, és időzítőként lejátszhatja.
line_all = Minden
line_out = Az időzítőnek
line_in = Az időzítőtől
line_damaged = Sérült
line_request = { $name } · { $letters }
line_reply = { $name }, válasz · { $letters }
line_echo = { $name }, visszhang · { $letters }
line_unknown = Ismeretlen betű: { $letter }
line_names_GETTIMERS = Idők kiolvasása
line_names_SETTIMERS = Idők beírása
line_names_GETSERVOPOS = Állások kiolvasása
line_names_SETSERVO = Egy állás beírása
line_names_MOVETOFUNC = Szervók mozgatása
line_names_GETSWVER = Azonosítás
line_names_UNLOCK = Motor feloldása
line_names_JUMP2 = Ugrás
line_names_GETMEMORY = Melyik memória
line_names_SETMEMORY = Memória kiválasztása
line_names_GETLOWRPM = Alapjárati gáz kiolvasása
line_names_SETLOWRPM = Alapjárati gáz beírása
line_rejected_noise = Sérült: zaj
line_rejected_length = Sérült: lehetetlen hossz
line_rejected_terminator = Sérült: nincs vége ott, ahol lennie kell
line_rejected_checksum = Sérült: hibás ellenőrző összeg
line_rejected_silence = Sérült: megszakadt
line_error_framing = Vonalhiba: keretezés
line_error_parity = Vonalhiba: paritás
line_error_break = Vonalhiba: szünetjel
line_error_overrun = Vonalhiba: túlcsordulás, bájtok vesztek el
line_error_other = Másfajta vonalhiba
line_position = { $slot }, { $servo }: { $steps } lépés
line_motorStop = motorleállítás { $time }
line_reserved = fenntartott { $time }
line_functions = funkciók { $times }
line_identity = { $name }, firmware { $firmware }, { $functions } és DT, { $memories }, { $servos }
line_memories = { $count } memória
line_memoryUnsaid = Nem mondja meg, melyik.
line_idleThrottle = { $value }, ismeretlen egység
line_idleThrottleUnsaid = Nem ad értéket.
line_acknowledged = Nyugtázva.
line_unreadable_wrong-length = A tartalma hosszabb vagy rövidebb, mint kellene.
line_unreadable_unknown-command = Nem tudni, mit jelent.
line_unreadable_unexpected-reply = Másik kérésre válaszol.
line_unreadable_bad-identity = Amit az időzítőről mond, nem lehet helyes.
line_unreadable_identity-needed = Akkor olvasható, ha az időzítő már megmondta, micsoda.
line_unreadable_out-of-range = Egy benne lévő érték nem lehet helyes.
line_unreadable_not-an-integer = { line_unreadable_out-of-range }
line_unreadable_wrong-count = { line_unreadable_out-of-range }
line_unreadable_wrong-type = { line_unreadable_out-of-range }
line_unreadable_unknown-word = A tartalma nem olvasható.
line_unreadable_bad-capture = { line_unreadable_unknown-word }
line_unreadable_bad-file = { line_unreadable_unknown-word }
line_unreadable_bad-link = { line_unreadable_unknown-word }
line_unreadable_newer-version = { line_unreadable_unknown-word }
line_unreadable_too-large = { line_unreadable_unknown-word }
line_unreadable_duplicate = { line_unreadable_unknown-word }
line_goOn = Folytatás
line_came = Szünetel. Azóta { $number } bejegyzés.
line_clear = Ürítés
line_unidentified = ismeretlen
line_load = Betöltés…
line_filter = Megjelenítés
line_searchHint = név vagy hexa
line_counts_out = { $count } az időzítőnek
line_counts_in = { $count } az időzítőtől
line_counts_damaged = { $count } sérült
line_counts_errors = { $count } vonalhiba
line_recording = { $name }: { $entries } bejegyzés felvétele.
line_replay = Lejátszás időzítőként
line_cannotReplay = Nem játszható le: az időzítő sehol nem mondja meg, micsoda.
line_back = Vissza az élő vonalhoz
line_noRecordingAt = { $line }. sor: ide idő kell másodpercben, > vagy <, és bájtok hexában.
line_noRecording = Ez a fájl nem felvétel.
line_send_title = Keret küldése kézzel
line_send_lead = A hosszt és az ellenőrző összeget az oldal teszi hozzá.
line_send_bytes = Betű és adat, hexában
line_send_faults_hex = Minden bájthoz két hexa számjegyet írjon: 0–9 vagy A–F.
line_send_faults_too-long = Egy keret legfeljebb 252 bájtot visz.
line_send_preview = Így megy ki
line_send_send = Küldés…
line_send_confirmTitle = Elküldi ezt a keretet az időzítőnek?
line_send_danger = A szervók elmozdulhatnak, a légcsavar elindulhat, és megváltozhat, ami az időzítőben van. Utána az oldal újra kiolvassa az időzítőt.
line_send_confirm = Igen, küldés egyszer
line_send_sending = Küldés
line_send_answered = Válasz:
line_send_unanswered = Nem jött válasz. Amit a keret kért, ettől még megtörténhetett.
line_copyReport = Jelentés másolása

## From the ports to a timer that answers.

link_portNames_ftdi = FTDI-adapter
link_portNames_cp210x = CP210x-adapter (Silicon Labs)
link_portNames_ch340 = CH340-adapter (WCH)
link_portNames_pl2303 = PL2303-adapter (Prolific)
link_portNames_bluetooth = Bluetooth
link_portNames_usb = USB-adapter
link_portNames_other = Soros port
link_stages_choosing = Válassza ki az időzítő adapterét
link_stages_openingLong_title = Az adapter lassan nyílik meg
link_stages_openingLong_advice = Bluetooth: kapcsolja be az adaptert a közelben. Kábel: húzza ki, és dugja be újra.
link_stages_asking = Kérdezés { $rate } baud sebességgel.
link_stages_noAnswer = { $seconds } s óta nincs válasz. Az oldal tovább kérdez, és magától folytatja.
link_stages_open = Az adapter nyitva van
link_stages_steps_switch = Ébressze fel az időzítőt: nyomja meg röviden a kapcsolóját
link_stages_steps_near = Tartsa az infravörös fejet 20 cm-nél közelebb, ne érje napfény
link_stages_steps_other = Másik adapteren van az időzítő?
link_refused = Az oldal 15 másodpercig újra próbálja. Lehet, hogy másik program foglalja az adaptert.
link_heard_title = Valami hallatszik, de nem válaszol időzítő.
link_heard_advice = Ébressze fel az időzítőt, tartsa közelebb a fejet, ne érje napfény, vagy válasszon másik adaptert.
link_slow_title = Egy időzítő válaszol, de túl lassan.
link_slow_advice = A bájtjai egyenként jönnek { $rate } baud sebességgel, olyan hosszú szünetekkel, hogy egy válasz sem ér ide időben egészben. Az oldal nem tudja kiolvasni. Próbáljon másik adaptert, vagy Bluetooth helyett kábelt.
link_itSaid = Ez jött: { $bytes } („{ $text }”).
link_trySelectBare = Próba helyes ellenőrző összeg nélkül
link_lost_title = Megszakadt a kapcsolat az adapterrel.
link_lost_advice = Dugja be, vagy hozza közel: az oldal magától folytatja. Amit begépelt, megmarad.
link_status_off = Nincs kapcsolat
link_status_opening = Kapcsolódás
link_status_searching = Időzítő keresése
link_status_away = Megszakadt a kapcsolat
link_status_closing = Bontás

## The known ports, and how they are opened.

ports_title = Ismert adapterek
ports_forget = Elfelejtés
ports_settings = Soros beállítások
ports_settingsHint = Csak különleges adapterhez. Az oldal magától megtalálja a sebességet.
ports_rate = Sebesség
ports_findRate = Keresés
ports_baud = { $rate } baud
ports_parity = Paritás
ports_parities_none = Nincs
ports_parities_even = Páros
ports_parities_odd = Páratlan
ports_stopBits = Stopbitek
ports_dtr = DTR
ports_rts = RTS
ports_signals_leave = Ahogy a böngésző beállítja
ports_signals_on = Be
ports_signals_off = Ki
ports_reset = Szokásos beállítások

## What is known about the connected timer. Its numbers are in the report.

aboutTimer_title = Erről az időzítőről
aboutTimer_damage = Sérülések a vonalon
aboutTimer_crowd = Lehet, hogy másik időzítő vagy programozó is van a sugárban. Azóta két kiolvasásnak kell egyeznie.
aboutTimer_found = Amit másképp tett
aboutTimer_nothingFound = Eddig semmi: minden kérést a szokásos módon teljesített.
aboutTimer_quirkNames_timers-reply-66 = Egy másik parancs betűjével válaszol.
aboutTimer_quirkNames_unlock-reply-6a = { aboutTimer_quirkNames_timers-reply-66 }
aboutTimer_quirkNames_memory-unknown = Nem mondja meg, melyik az aktuális memória.
aboutTimer_quirkNames_memory-impossible = { aboutTimer_quirkNames_memory-unknown }
aboutTimer_quirkNames_bare-checksum = Az alapjárati gázról nem a szokásos módon válaszol.
aboutTimer_quirkNames_times-big-endian = Az idői csökkennek. Az idők két bájtját felcserélve növekednének.
aboutTimer_quirkNames_servo-first = Állás írásakor a szervót várja a funkció előtt.
aboutTimer_quirkNames_servo-unanswered = Nem válaszolt, amikor egy állás beírása történt.
aboutTimer_quirkNames_times-rounded = Kerekíti az időket.
aboutTimer_quirkNames_memories-from-one = A memóriáit 1-től számozza.
aboutTimer_quirkNames_positions-unchanged = Nyugtázott állásokat, de nem tartotta meg őket.
aboutTimer_quirkNames_echo = Az adapter visszaküldi, amit kap.
aboutTimer_quirkNames_idle-throttle-unanswered = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_identity-unusual = Amit magáról mond, abban ismeretlen bájtok vannak.
aboutTimer_quirkNames_idle-throttle-malformed = { aboutTimer_quirkNames_bare-checksum }
aboutTimer_quirkNames_replies-alike = Néhány kérésre adott válaszai sérültek, mindig ugyanúgy.
aboutTimer_assumed = Ismert eltérések
aboutTimer_assumedHint = Ehhez az adapterhez és ehhez az időzítőfajtához megjegyezve.
aboutTimer_forget = Ismert eltérések elfelejtése
aboutTimer_assumptions_bigEndianTimes = Minden idő két bájtja fel van cserélve
aboutTimer_assumptions_servoFirst = { aboutTimer_quirkNames_servo-first }
aboutTimer_assumptions_memoriesFromOne = { aboutTimer_quirkNames_memories-from-one }
aboutTimer_assumptions_bareChecksumRequests = A „memória kiválasztása” és az „alapjárati gáz beírása” helyes ellenőrző összeg nélkül megy ki
aboutTimer_assumptions_positionsNeedMove = Az állások csak ott maradnak meg, ahol a szervók állnak

## Which memory flies next, and what is known about the others.

nextFlight_badge = következő repülés
nextFlight_onScreen = Ez az { $memory }.
nextFlight_named = { $memory }, következő repülés
nextFlight_other = Következő repülés: { $memory }.
nextFlight_last = Az { $memory } volt az aktuális, amikor az időzítő utoljára válaszolt. A következő repülés ezzel lesz, hacsak valami más ezt meg nem változtatta.
nextFlight_original = Amikor kapcsolódott, az { $original } volt az aktuális.
nextFlight_originalUnknown = Nem tudni, melyik volt az aktuális, amikor kapcsolódott.
nextFlight_unknown = Nem tudni, melyik memóriával lesz a következő repülés.
nextFlight_asked = Utoljára az { $memory } lett kiválasztva.
nextFlight_back = Vissza ide: { $original }
nextFlight_leaving_title = Mielőtt bontja a kapcsolatot
nextFlight_leaving_back = Vissza ide: { $original }, majd bontás
nextFlight_leaving_failed = Az időzítő nem tért vissza ide: { $original }. A kapcsolat még megvan.

## The last reading of a memory that is not current.

look_read = { $memory }, kiolvasva { $time }
look_notRead = Az { $memory } nincs kiolvasva
look_either = Vagy ez
look_or = vagy ez
look_lead = Csak megtekintés. Következő repülés: { $current }.
look_edit = { $memory } szerkesztése
look_look = { $memory } megtekintése
look_hint = Ez kiválasztja az { $memory } memóriát, kiolvassa, majd visszatér ide: { $current }.
look_fly = { $memory } legyen a repüléshez
look_show = { $memory } megjelenítése

## Jobs over several memories, and the backups.

memories_copy = { $from } másolása ide: { $to }
memories_restore = Biztonsági másolat visszaállítása
memories_restoreAll = Mind a { $count } visszaállítása…
memories_plans_screen =
    { $keepsThrottle ->
        [true] Az { $to } a képernyőn lévő időket és állásokat fogja tartalmazni. A mostani tartalmáról előbb biztonsági másolat készül. Az alapjárati gáz változatlan marad.
       *[false] Az { $to } a képernyőn lévő időket és állásokat fogja tartalmazni. A mostani tartalmáról előbb biztonsági másolat készül.
    }
memories_plans_copy = Az { $to } az { $from } memória épp most kiolvasott időit és állásait fogja tartalmazni. Az { $to } mostani tartalmáról előbb biztonsági másolat készül.
memories_plans_restore = A biztonsági másolat ({ $time }) ide íródik be: { $names }. Ami most ott van, arról előbb biztonsági másolat készül.
memories_atEnd = A végén a következő repüléshez ismét az { $current } lesz kiválasztva.
memories_refused = Ide semmi nem írható be ({ $memory }): ezeket az értékeket semmilyen szoftver nem tudja elküldeni.
memories_untouched = Ide semmi nem lett beírva: { $memory }.
memories_stopped = Ami még nem lett beírva, az az időzítőben változatlan.

## All memories of a timer at a glance.

overview_readAll = Mind kiolvasása és megőrzése
overview_copyTo = Másolás ide…
overview_compareWith = Összevetés: { $memory }
overview_readAt = kiolvasva { $time }
overview_notCertain = Bizonytalan: egy írás itt megszakadt. Az írás előtti állapot látszik.
overview_edited = Úgy látszik és úgy másolódik, ahogy az időzítőben van, az Ön módosításai nélkül.
overview_same = Ugyanaz van bennük.
overview_differs = { $count } érték eltér.

## How the timer writes its times: the question that no reading can answer.

byteOrder_title = Ennek az időzítőnek az idői sorról sorra csökkennek.
byteOrder_advice = Növekednének, ha minden idő két bájtja fel lenne cserélve. Hasonlítsa össze azzal, amit az időzítőről tud, és írás előtt válasszon.
byteOrder_keep = Így helyesek, ahogy látszanak
byteOrder_exchange = Felcserélés és kiolvasás újra

## Why there is no connection.

connection_unsupported_title = { unsupportedHere_title }
connection_unsupported_advice = { unsupportedHere_advice }
connection_insecure_title = A böngésző itt nem engedi a soros portokat.
connection_insecure_advice = { restWorks }
connection_policy_title = Az oldal szervere tiltja a soros portokat.
connection_policy_advice = { restWorks }
connection_nothing-chosen_title = Nem lett adapter kiválasztva.
connection_nothing-chosen_advice = Nyomja meg a Kapcsolódás gombot, és válassza ki az adaptert. Ha nincs a listában, az alábbi lépések segítenek.
connection_not-allowed_title = { connection_insecure_title }
connection_not-allowed_advice = Engedélyezze a soros portokat ennek az oldalnak a böngésző beállításaiban, majd nyomja meg újra a Kapcsolódás gombot.
connection_busy_title = Az adapter nem nyílik meg.
connection_busy_advice = Legtöbbször másik program vagy lap foglalja. Zárja be azt, majd nyomja meg újra a Kapcsolódás gombot.
connection_bad-settings_title = Az adapter nem fogadja el ezeket a beállításokat.
connection_bad-settings_advice = { help_steps_usual-settings }
connection_unplugged_title = Az adapter nem érhető el.
connection_unplugged_advice = Húzza ki, dugja be újra, és nyomja meg a Kapcsolódás gombot. Amit begépelt, megmarad.
connection_bad-reply_title = { link_heard_title }
connection_bad-reply_advice = { link_heard_advice }
connection_lost_title = { connection_unplugged_title }
connection_lost_advice = { connection_unplugged_advice }

## Why a job with the timer has ended.

timer_no-answer_title = Az időzítő nem válaszolt.
timer_no-answer_advice = Nyomja meg röviden az időzítő kapcsolóját, tartsa a fejet 20 cm-nél közelebb, és próbálja újra. Amit begépelt, megmarad.
timer_bad-reply_title = Az időzítő válasza nem lehet helyes.
timer_bad-reply_advice = Próbálja újra. Ha újra előfordul: Beállítások, Szakértő, Vonal, „{ line_copyReport }”.
timer_unstable_title = A vonal túl zajos ahhoz, hogy meg lehessen bízni benne.
timer_unstable_advice = Tartsa közelebb az infravörös fejet, ne érje napfény, és próbálja újra.
timer_crowded_title = Lehet, hogy egynél több időzítő van a sugárban.
timer_crowded_advice = Tartsa távol a többi időzítőt és programozót, és olvassa ki újra.
timer_other-memory_title = Az aktuális memória nem az, amely a képernyőn van.
timer_other-memory_advice = Írás előtt olvassa ki újra.
timer_memory-unknown_title = Ez az időzítő nem mondja meg, melyik az aktuális memória.
timer_memory-unknown_advice = Ezért az oldal nem tud másik memóriát megnézni és visszatérni. Az aktuálisat kiolvashatja és írhatja.
timer_memory-left_title = Lehet, hogy megváltozott, melyik memóriával lesz a következő repülés.
timer_memory-left_advice = Az oldal nem tudott visszatérni a korábbi aktuális memóriához. Kapcsolódjon újra, és repülés előtt válassza ki a megfelelő memóriát a következő repüléshez.
timer_other-timer_title = Ez nem az az időzítő, amely korábban válaszolt.
timer_other-timer_advice = Az oldal most kiolvassa. Írás előtt nézze meg, mi van benne.
timer_stale_title = Az időzítőben nem az van, ami a képernyőn látszott.
timer_stale_advice = Semmi nem lett beírva. Nézze meg, mit módosítana most egy írás.
timer_changed_title = Az időzítőben más értékek vannak, mint korábban.
timer_changed_advice = Valami más módosította az időzítőt, vagy ez másik időzítő. Az Ön módosításai megmaradtak: írás előtt nézze meg az eltérést.
timer_stood-still_title = Ez az oldal munka közben egy ideig szünetelt.
timer_stood-still_advice = Azután már semmit nem küldött: lehet, hogy most másik időzítő van ott. Olvassa ki újra.
timer_too-slow_title = Ez az időzítő túl lassan válaszol.
timer_too-slow_advice = A válaszaira 3 másodpercnél többet kell várni, ezért az oldal nem tudja, melyik melyik kérdéshez tartozik. Ezután már semmit nem küldött. Próbáljon másik adaptert, vagy Bluetooth helyett kábelt.
timer_undecided_title = { byteOrder_title }
timer_undecided_advice = { byteOrder_advice }
timer_serious_title = A vizsgálat valami súlyosat talált.
timer_serious_advice = { timer_stale_advice }
timer_busy_title = Valami ezen az oldalon vagy a számítógépen használja az adaptert.
timer_busy_advice = Semmi nem lett elküldve. Bontsa a kapcsolatot, és kapcsolódjon újra. Amit begépelt, megmarad.
timer_port-lost_title = { link_lost_title }
timer_port-lost_advice = { link_lost_advice }
timer_aborted_title = Leállítva.
timer_aborted_advice = Olvassa ki újra, hogy lássa, mi van az időzítőben.
timer_closed_title = A kapcsolat bontva.
timer_closed_advice = A folytatáshoz nyomja meg a Kapcsolódás gombot. Amit begépelt, megmarad.

## Replies that are no noise, which is random.

alike_title = Erre a kérésre minden válasz ugyanúgy sérült: { $request }.
alike_advice = Ez nem zaj: az időzítő vagy az adaptere ismeretlen módon képezi ezeket a válaszokat. Kapcsolja be a Szakértő beállítást, nyissa meg a Vonal nézetet, és nyomja meg: „{ line_copyReport }”. Küldje el a jelentést a karbantartóknak (github.com/sidus-timer/sidus-timer/issues).
alike_part = Csak megtekintésre: { $values }. Minden más ismeretlen.

## Messages that are not about errors.

notes_back_title = Visszatértek a módosításai.
notes_back_advice = Hasonlítsa össze őket azzal, ami az időzítőben van, majd írja be vagy vonja vissza őket.
notes_back-uncertain_title = { notes_back_title }
notes_back-uncertain_advice = Nem tudni, be lettek-e írva. Repülés előtt kapcsolódjon az időzítőhöz, és olvassa ki.
notes_moved_title = { timer_changed_title }
notes_moved_advice = { timer_changed_advice }
notes_timer-moved_title = { timer_changed_title }
notes_timer-moved_advice = { timer_changed_advice }
notes_kept_title = A módosításai megmaradnak ezen az eszközön.
notes_kept_advice = Nem illenek ahhoz, ami most lett kiolvasva. Visszatérnek, amikor azt a memóriát újra kiolvassa; a kezdőlap is felsorolja őket.
notes_other-kind_title = Most másfajta időzítő van ott.
notes_other-kind_advice = { timer_other-timer_advice }
notes_write-completed_title = A megszakadt írás teljes.
notes_write-completed_advice = Az időzítő újra ki lett olvasva, és benne van minden, aminek be kellett kerülnie.
notes_nothing-written_title = { write_refused }
notes_nothing-written_advice = {""}
notes_not-backed-up_title = { write_unkept_title }
notes_not-backed-up_advice = { keeping_notKept }
notes_select-unanswered_title = Az időzítő nem válaszolt, amikor memóriát kellett kiválasztani.
notes_select-unanswered_advice = Más kérésekre válaszol. Próbálja újra, vagy próbálja meg helyes ellenőrző összeg nélkül.
notes_backed-up_title = Minden memória ki lett olvasva, és mindegyikről megvan a biztonsági másolat.
notes_backed-up_advice = {""}
notes_strays_title = { timer_crowded_title }
notes_strays_advice = { timer_crowded_advice }
notes_made-laid_title = A táblázatban az Ön programja látszik, nem az, ami az időzítőben van.
notes_made-laid_advice = Semmi nem lett beírva. Az eltérés meg van jelölve. A „{ undo }” megmutatja, mi van az időzítőben.
notes_unexpected_title = Hiba történt ezen az oldalon.
notes_unexpected_advice = Ezután az oldal már semmit nem küldött. Töltse be újra az oldalt. Amit begépelt, megmarad.

## The flight of the program, and what the servos of the model move.

preview_title = A repülés előnézete
preview_guessed = Nem méretarányos.
preview_nameServos = Szervók elnevezése…
preview_play = Lejátszás
preview_speed = Sebesség
preview_time = A repülés ideje
preview_launch = Start
preview_at = { $what } ekkor: { $time }
preview_sketch = A modell oldalról, az oldalkormánya felülről
preview_motor_true = Emelkedés, jár a motor
preview_motor_false = Siklás, áll a motor
preview_flies = Repül
preview_comesDown = DT: a modell lejön
preview_duties_rudder = Oldalkormány
preview_duties_tailplane = Vezérsík
preview_duties_wing = Szárny
preview_duties_release = Tárcsa vagy DT-zsinór
preview_duties_other = Valami más
preview_duties_none = Nincs használatban
preview_naming_lead = Mit mozgat az egyes szervó, és milyen lépések között. A föl és a le a kilépőélre vonatkozik.
preview_naming_duty = { $servo } ezt mozgatja
preview_naming_name = Amit az { $servo } mozgat, annak neve
preview_naming_low = { $servo }, egyik vége lépésben
preview_naming_high = { $servo }, másik vége lépésben
preview_naming_from = ettől
preview_naming_to = eddig
preview_naming_sense = { $servo }, mit tesz több lépés
preview_naming_otherSense_false = több lépés: föl
preview_naming_otherSense_true = több lépés: le
preview_naming_rudderSense_false = több lépés: jobbra
preview_naming_rudderSense_true = több lépés: balra

## The sheet of a program.

print_paper = Papír
print_what = A lapon
print_parts_lines = Vonalak kézíráshoz
print_parts_code = QR-kód
print_nothing = Válasszon programokat a könyvtárból, vagy nyisson meg egyet.
print_choose = Programok ezen a nyomaton: { $chosen }
print_clear = Mind eltávolítása
print_simulated = szimulált időzítő
print_warnings = Ezt nézze meg repülés előtt
print_notes = Megjegyzések
print_codeHint = Egy telefon kamerája megnyitja ezt a programot, a megjegyzése nélkül.
print_unfinished = { $count } mezőnek még nincs értéke: a legutóbbi van kinyomtatva
print_printed = Nyomtatva: { $date }

## The model in the strip.

recognition_which = Melyik modell?
recognition_change = Modell: { $model }. Adja meg, melyik modell ez

## A memory with the pilot's name for it: M2 “fly-off”.

memoryNames_named = { $memory } „{ $name }”

## What an earlier job left behind on a timer.

recovery_title = Egy korábbi írás megszakadt.
recovery_when = Az írás kezdete: { $time }, memória: { $memory }.
recovery_nothing = Az időzítőben az van, ami előtte volt: semmi nem lett beírva, { $missing } módosítás hiányzik.
recovery_part = Az időzítőben ennyi van meg abból az írásból: { $values }; { $missing } érték még olyan, mint előtte.
recovery_foreign = { $count } érték az időzítőben nem a régi, és nem is abból az írásból való. Másik időzítő ez, vagy valami más módosította?
recovery_sure = Az oldal nem tudja megkülönböztetni az azonos fajtájú időzítőket. Csak akkor folytassa, ha ez annak az írásnak az időzítője.
recovery_finish = Írás befejezése…
recovery_goBack = Régi értékek visszaírása…
recovery_leave = Maradjon így
recovery_otherTimer = Ez másik időzítő
recovery_sameTimer = Ez ugyanaz az időzítő: mutassa, mi volt beírandó
recovery_compare = Összevetés
recovery_before = Előtte
recovery_elsewhere = Egy ilyen fajta időzítőn megszakadt egy írás. Memória: { $memory }. Olvassa ki, hogy lássa, mi van benne.
recovery_left = Az oldal munkája a memóriákon megszakadt. Következő repülés: most { $current }, előtte { $original }.
recovery_mayFly = Lehet, hogy a következő repülés ezzel lesz: { $memory }. Ennek a memóriának a kiválasztása megszakadt.
recovery_mayNotFly = Az oldal munkája a memóriákon megszakadt. Lehet, hogy a következő repülés nem ezzel lesz: { $original }, hanem másik memóriával.
recovery_unknownMemory = ismeretlen memória

## The backups.

backups_title = Biztonsági másolatok
backups_empty = Minden írás előtt itt őrzi meg az oldal, ami az időzítőben van.
backups_reasons_write = írás előtt
backups_reasons_memories = minden memória

## How the page looks.

theme_title = Színek
theme_names_system = Rendszer
theme_names_light = Világos
theme_names_dark = Sötét
theme_names_sun = Napfény

## The settings of the page.

settings_look = Megjelenés
settings_expert = Szakértő: a vonal megjelenítése
settings_expertHint = A vonal minden bájtot megmutat az oldal és az időzítő között. A „{ views_names_bench }” nézetben egy nem dokumentált ugrás is megjelenik.
settings_kept = Amit ez az eszköz megőriz

## A saved program as a link and a QR code, and back.

share_offer_lead = A link a teljes programot tartalmazza. Szerverre nem kerül semmi.
share_offer_link = Link
share_offer_copy = Link másolása
share_offer_scan = Irányítsa a másik eszköz kameráját erre a kódra, vagy küldje el a linket.
share_offer_qr = QR-kód: „{ $name }”
share_offer_cut = A megjegyzés vége nem fér a QR-kódba. A linkben a teljes megjegyzés benne van.
share_offer_tooLong = Túl hosszú egy QR-kódhoz. Küldje el a linket.
share_received_title = Program egy linkből
share_received_lead = Az oldal egyelőre csak mutatja. Semmi nem őrződik meg, és időzítőbe sem íródik be semmi.
share_received_known = Ezek az értékek már megvannak a könyvtárban: { $name }.
share_received_modelChoice = Megőrzés itt
share_received_newModel = Új modell: „{ $name }”
share_received_keep = Megőrzés a könyvtárban
share_received_discard = Elvetés
share_received_unwritten = Amit begépelt, megmarad: a „{ undo }” vagy a kezdőlap visszahozza.
share_damaged_title = Ez a link nem olvasható.
share_damaged_bad = Csonka vagy sérült, vagy nem erről az oldalról való. Kérje el újra.
share_paste_title = Link beillesztése…
share_paste_lead = Egy telefon kamerája magától megnyitja a QR-kódot. Ide linket illeszthet be.
share_paste_show = Megjelenítés
share_paste_notLink = Ez nem egy program linkje.

## A DT for trimming that is about to be flown. The page asks before the pilot disconnects, and at a contest round.

shortDt_held = { $memory }: a DT { $dt }.
shortDt_heldHere = A DT { $dt }.
shortDt_ask =
    { $remembered ->
        [true] Visszaállítja erre: { $back }?
       *[false] Beállítja erre: { $back }?
    }
shortDt_putBack =
    { $remembered ->
        [true] DT vissza erre: { $back }…
       *[false] DT legyen { $back }…
    }
shortDt_disconnect = Bontás így: { $memory }, DT{"\u00a0"}{ $dt }
shortDt_disconnectHere = Bontás így: DT{"\u00a0"}{ $dt }
shortDt_blocked = Valami, amit begépelt, még nem írható be. Javítsa ki, mielőtt visszaállítja a DT-t.
shortDt_settings_limit = Rövid a DT ez alatt
shortDt_settings_hint = A rövidebb DT piros, és az oldal rákérdez, mielőtt Ön bontja a kapcsolatot. 0 s esetén soha nem kérdez.

## The start, before anything was read.

start_title = Sidus időzítő beállítása
start_lead = Olvassa ki, ami benne van, módosítsa, írja be, és lássa igazolva. Semmi nem hagyja el ezt az eszközt.
start_adapter = Dugja be az adaptert
start_firefox = A Firefox előbb engedélyt kér, és az oldal minden betöltésekor a portot is.
start_android = A telefon Bluetooth-on kapcsolódik; kábelhez Android { firstVersions_androidCable } és Chrome { firstVersions_android } kell.
start_readyOffline = Hálózat nélkül is kész
start_install = Telepítés
start_picture_example = Példa: egy F1Q
start_picture_kept = Megőrizve: { $time }
start_models_title = Modelljeim
start_models_none = Őrizze meg minden modell programjait, megjegyzésekkel.
start_models_programs = { $count } program
start_models_library = Könyvtár megnyitása
start_programs_title = Nincs befejezve
start_programs_made = { $timer }, új
start_programs_changesOf = { $timer }, módosítások
start_programs_sure = Végleg törli?
start_simulatedTitle = Nincs itt időzítő?
start_simulatedLead = A szimulált úgy válaszol, mint az igazi, bájtról bájtra.
start_simulated = Szimulált { $name } kipróbálása
start_backups = { $count } biztonsági másolat, írás előtt megőrizve. A legutóbbi: { $last }.

## The dialog that makes a program without a timer.

newProgram_title = Új program…
newProgram_timerClass = Osztály
newProgram_functions = Funkciók, start és DT nélkül
newProgram_servos = Szervók
newProgram_from = Kiindulás
newProgram_beginnings_usual = Szokásos idők, szervók középen
newProgram_beginnings_nothing = Minden idő és állás 0
newProgram_caution = A modellje állásai itt nem ismertek. Írás előtt állítsa be mindegyiket.
newProgram_make = Program létrehozása

## The picture of a program over time.

timeline_title = Idővonal
timeline_compareBefore = követés előtt
timeline_picture = Szervóállások az idő szerint
timeline_description = { $servos } és { $functions } az idő szerint, DT: { $dt }. Minden érték a táblázatban van.
timeline_descriptionMotor = { $servos } és { $functions } az idő szerint, DT: { $dt }, motorleállítás: { $motorStop }. Minden érték a táblázatban van.
timeline_functions = { $count } funkció
timeline_servos = { $count } szervó
timeline_keysToEdit = A nyilak jelről jelre és szervóról szervóra lépnek, plusz és mínusz nagyít és kicsinyít, a 0 mindent mutat. Az Enter a fogantyúkhoz visz: ezeket a nyilak mozgatják, az Escape visszalép.
timeline_ask = Leolvasáshoz mutasson rá vagy érintse meg
timeline_finer = Finomabban
timeline_steps = { $position } lépés
timeline_stepsUnit = lépés
timeline_notKnown = Nem tudni: az idők csökkennek
timeline_tools = Nézet
timeline_zoomIn = Nagyítás
timeline_zoomOut = Kicsinyítés
timeline_fit = Minden látszik
timeline_passedOver = { $slot } kimarad: { $next } ugyanakkor jön.
timeline_goesBack = { $next } előbb jön, mint { $slot }. Nem tudni, mit tesz az időzítő a satírozott részben.

## A new version of the page.

update_ready = Kész egy új változat.
update_waits = Akkor indul, ha bontja a kapcsolatot, és nincs semmi nyitva vagy mentetlen.
update_take = Használat most
update_news = Újdonságok

## The version of this page.

aboutPage_title = Ez az oldal
aboutPage_version = Sidus Timer { $version }.
aboutPage_offline = Az egész oldal ezen az eszközön van: hálózat nélkül is működik.
aboutPage_notOffline = Az oldal még nincs megőrizve ezen az eszközön: nyissa meg egyszer hálózattal.
aboutPage_licences = Licencek

## The views of the page and the links between them.

views_title = Nézetek
views_names_program = Program
views_names_memories = Memóriák
views_names_bench = Próbapad
views_names_library = Könyvtár
views_names_line = Vonal
views_names_settings = Beállítások
views_names_print = Nyomtatás
views_names_help = Súgó
views_print = Nyomtatás…
views_share = Megosztás…
views_noTimer_memories = Kapcsolódjon egy időzítőhöz, hogy lássa a memóriáit. A biztonsági másolatok lent vannak.
views_noTimer_bench = Kapcsolódjon egy időzítőhöz, hogy mozgassa a szervóit.

## The strip above every view: the timer, its memory, DT, motor stop, and what is known.

strip_panel = Memóriák és egyebek
strip_tried = { $count } kipróbálva
strip_notCertain = bizonytalan
strip_asRead = utolsó kiolvasás
strip_notValid = érvénytelen
strip_ofSetting =
    { $changes ->
        [0] mentve
       *[other] { $changes } mentetlen
    }
strip_made = nincs időzítőben

## The list of commands.

palette_title = Parancsok
palette_search = Írja be, mit szeretne
palette_nothing = Nincs ilyen nevű parancs, vagy most nem hajtható végre.
palette_ctrl = Ctrl+{ $key }

## In place of a part of the page that is being loaded.

parts_coming = Betöltés
parts_failed = Az oldal egy része nem töltődött be.
parts_again = Újra

## Which model it is.

whichModel_recognition_same = Ez { $model }, ugyanaz van benne, mint ekkor: { $when }.
whichModel_recognition_like = Erre hasonlít: { $model }, { $count } érték eltér. Ez { $model }?
whichModel_recognition_several = Ez lehet { $models }. Melyik modell ez?
whichModel_or = { $names } vagy { $last }
whichModel_others = még { $count }
whichModel_recognition_unknown = Ez az időzítő itt nem ismert. Melyik modell ez?
whichModel_recognition_yes = Igen, { $model }
whichModel_recognition_choose = Választás…
whichModel_recognition_ok = OK
whichModel_recognition_dialog_title = Melyik modell ez?
whichModel_recognition_dialog_lead = Az időzítő nem ismeri a modelljét. Az oldal azzal veti össze a tartalmát, amit az egyes modellekben utoljára látott.
whichModel_recognition_dialog_said = Ön azt mondta, hogy ez { $model }.
whichModel_recognition_dialog_moreMemories = Olvassa ki a többi memóriát is: azok megkülönböztethetik a modelleket.
whichModel_recognition_dialog_none = Nincs ilyen modell ebben az osztályban.
whichModel_recognition_dialog_newModel = Új modell
whichModel_recognition_dialog_keep = Megőrzés új modellként
whichModel_memoryNames_label = { $memory } neve
whichModel_memoryNames_give = Elnevezés
whichModel_crossing_title = Ezek { $from } értékei, de ez az időzítő { $to } időzítőjének látszik.
whichModel_crossing_advice = Másik modell értékeivel elveszítheti ezt a modellt. Nézze meg a modellt, amely Ön előtt van.
whichModel_crossing_confirm = { $from } értékeinek beírása { $to } időzítőjébe.
whichModel_crossing_memoryOf = { $memory } ({ $model })

## A write, from the difference to the verdict.

write_title = Írás az időzítőbe
write_lead = Ez fog változni. Memória: { $memory }. Minden más marad, ahogy van.
write_target = Írás ide
write_nothing = Nincs eltérés. Az oldal visszaolvassa az időzítőt, és összeveti.
write_field = Érték
write_from = Időzítőben
write_to = Ez lesz
write_wasRead = Korábbi kiolvasás
write_moved_model_title = Úgy tűnik, ez az időzítő most másik modellhez tartozik.
write_moved_model_advice = Semmi nem lett beírva. Nézze meg a modellek nevét.
write_moved_edits_title = A program megváltozott, mióta ez megjelent.
write_unkept_title = Ez az eszköz nem tudta megőrizni a biztonsági másolatot arról, ami most az időzítőben van.
write_unkept_advice = Ez a memória még változatlan. Folytatja biztonsági másolat nélkül?
write_sideBySide = Értékek: { $names }
write_withoutCopy = Folytatás biztonsági másolat nélkül
write_safety = A légcsavar le van véve, vagy valaki fogja a modellt, az időzítő pedig nincs élesítve.
write_acknowledge = Ezt elolvastam, és mégis be akarom írni.
write_stillToTick = Még ki kell pipálni: { $ticks }.
write_ticks_model = másik modell
write_ticks_warnings = figyelmeztetések
write_ticks_safety = légcsavar
write_move_why = Úgy tűnik, ez az időzítő csak ott tart meg állásokat, ahol a szervói állnak. Ha a szervók nem mozdulnak, ezeket valószínűleg nem tartja meg.
write_move_label = A szervók menjenek oda minden funkcióhoz, mielőtt az állásai bekerülnek az időzítőbe.
write_move_hint = Fogja biztosan a modellt, semmi ne legyen a szervók útjában.
write_move_notHeld_title = Az időzítő nyugtázta az állásokat, de nem tartotta meg őket.
write_move_notHeld_advice = Ez az időzítő valószínűleg csak ott tartja meg őket, ahol a szervói állnak. Írjon újra, és hagyja, hogy a szervók minden funkcióhoz odamenjenek.
write_move_again = Írás újra…
write_start =
    { $count ->
        [0] Visszaolvasás és összevetés
       *[other] { $count } módosítás beírása
    }
write_stages_read = Kiolvasás
write_stages_write = Írás
write_stages_verify = Visszaolvasás
write_stages_repair = Javítás
write_stopping = Leállás e kérés után
write_stoppingBack = Leállás: előbb vissza a korábbi memóriához
write_verified_title = Igazolva.
write_verified_advice = Az időzítő vissza lett olvasva, és az van benne, ami látszott.
write_verdict = { $memory } igazolva { $time }
write_asItIs = ahogy van
write_insteadOf = e helyett: { $value }
write_wanted = Beírandó
write_readBack = Visszaolvasva
write_differs_title = Az időzítő nem minden értéket vett át.
write_differs_advice = Az időzítő vissza lett olvasva. Itt más értékek vannak benne:
write_unknown_title = Bizonytalan, mi van az időzítőben.
write_unknown_advice = Az időzítőt nem sikerült teljesen visszaolvasni. Olvassa ki újra, majd írja be, ami még eltér. A módosításai megmaradnak.
write_cut = Az írás megszakadt, memória: { $memory }.
write_strayed_title = Írás közben az { $memory } lett az aktuális.
write_strayed_advice = Lehet, hogy az értékek egy része most itt van: { $memory }. Olvassa ki, és nézze át az egész memóriát, mielőtt repül vele.
write_refused = Semmi nem lett beírva.
write_status_differs = eltér
write_status_unknown = nem ismert
write_putBack = magától megváltozott, visszaállítva

## What the parts of the page that are loaded first say.

name = Sidus Timer
classNames_Q = F1Q
classNames_B = F1B
classNames_E = F1E
unknownClass = { $letter } osztály
memoryName = M{ $number }
servoName = S{ $number }
slotName =
    { $kind ->
        [start] Start
        [dt] DT
       *[function] { $slot }. funkció
    }
within_slot =
    { $kind ->
        [start] start
        [dt] DT
       *[function] { $slot }. funkció
    }
within_idleThrottle = alapjárati gáz
slotShort =
    { $kind ->
        [start] Start
        [dt] DT
       *[function] { $slot }
    }
about = { $name }:
previous = Előző
next = Következő
pause = Szünet
less = { $what }: kevesebb
moreOf = { $what }: több
seconds = { $time }{" "}s
times_minutes = { $minutes }{" "}min
times_minutesSeconds = { $minutes }{" "}min { $seconds }{" "}s
times_units_s = s
times_units_min = min
times_figure = { $text } { $unit }
times_asSeconds = { $seconds }{" "}s, { $clock }
times_meaning = { $field }: mit jelent, amit begépelt
header_firmware = firmware { $firmware }
header_simulated = szimulált
header_connect = Kapcsolódás
header_choosePort = Másik adapter
header_closeProgram = Program bezárása
header_disconnect = Bontás
header_stop = Stop
program_tableCaption = Minden funkció ideje és szervóállásai
program_slot = Funkció
program_time = Idő
program_memory = Memória
program_memoryUnknown = Ez az időzítő nem mondja meg, melyik az aktuális memória, ezért nem tudni, melyikkel lesz a következő repülés.
program_memoryOpen = Nem tudni, melyik memóriával lesz a következő repülés. Válasszon ki egyet a következő repüléshez, vagy olvassa ki újra.
program_dt = DT
program_motorStop = Motorleállítás
program_motor = Motor
program_idleThrottle = Alapjárati gáz
program_throttle = Alapjárat
program_idleThrottleUnit = ismeretlen egység
program_reserved = fenntartott { $time }
program_timeOf = { $slot }, idő
program_motorStopTime = Motorleállítás ideje
program_positionOf = { $slot }, { $servo }
program_shortDt = Rövid DT
program_changes = { $count } módosítás
program_undoAll = Mind vissza
program_read = Kiolvasás újra
program_connectAndWrite = Kapcsolódás és írás…
program_write =
    { $count ->
        [0] Írás…
       *[other] { $count } módosítás beírása…
    }
program_picture = Kép
program_table = Táblázat
program_blocked = Még nem írható be semmi. { $field }: { $why }
program_findings = Vizsgálat
program_noFindings = Nincs semmi szokatlan.
program_absolute = Az idők a starttól számítva láthatók. Nem tudni, hogy ez az időzítő a starttól vagy az előző funkciótól számol.
program_severity_error = Nem írható be
program_severity_serious = Súlyos
program_severity_warning = Szokatlan
program_reading = Az időzítő kiolvasása
program_selecting = Memóriaváltás
otherTab_holdsSince = A Sidus Timer másik lapon van nyitva, ekkortól: { $since }.
otherTab_holds = A Sidus Timer másik lapon van nyitva.
otherTab_takeOver = Használat itt
otherTab_busy = A másik lap az időzítővel dolgozik. Amint ez véget ér, itt nyílik meg.
otherTab_gone = A másik lap nem válaszol. Zárja be, majd töltse be újra ezt az oldalt.
disturbed = Válaszok hiányoznak vagy sérültek: ébren van az időzítő, és elég közel van az infravörös fej, napfény nélkül? Ez legkésőbb { $seconds } s múlva véget ér.
cancel = Mégse
close = Bezárás
copy = Másolás
copied = Másolva.
copyByHand = A böngésző nem engedi az oldalnak a másolást. Innen másolja ki.
dismiss = Elrejtés
done = Kész
undo = Visszavonás
open = Megnyitás
save = Mentés
delete = Törlés
notNow = Most nem
label_language = Nyelv
label_name = Név
label_note = Megjegyzés
label_model = Modell
label_search = Keresés
noModel = Nincs modell
more = És még { $count }.
showMore = Még { $count }
of = { $button }: { $name }
notFitting = Nem illik a csatlakoztatott időzítőhöz. A megnyitáshoz bontsa a kapcsolatot.
notKept = Ez a böngésző nem őrizte meg: elvész, ha ezt az oldalt bezárja.

## The walk through the open questions of docs/protocol.md with a real timer.

settle_title = Tisztázás az Ön időzítőjével
settle_lead = Nem minden ismert abból, hogyan beszélnek ezek az időzítők. Az Öné tizenöt perc alatt tisztázza, ami nyitott. Minden próba után visszaáll a régi érték. Legyen kéznél a kézi programozó.
settle_safe = A légcsavar le van véve, vagy a motor le van választva, az időzítő pedig nincs élesítve.
settle_danger = Most valami elmozdulhat. Le van véve a légcsavar, vagy le van választva a motor? Nézze meg még egyszer.
settle_blocked = Előbb intézze el, amit a fenti színes sáv ír, és tartsa meg, amit kipróbált, vagy állítsa vissza, ami előtte volt.
settle_readIt = Időzítő kiolvasása
settle_which = Melyiket mutatja a kézi programozó?
settle_tryHint = Mozgassa a szervókat az oldal gombjaival, és várja meg, amíg megállnak. Utána próbáljon ki egy állást: az oldal módosítja, majd másodperceken belül visszaállítja. Figyelje a szervókat.
settle_tryIt = Állás kipróbálása
settle_moved = A régi állás újra az időzítőben van: az oldal kiolvasta. Elmozdult egy szervó az új állás kipróbálásakor?
settle_ask = Kérdezés négy nullával
settle_unknown = Nem tudom
settle_send = Fájl küldése ezzel az űrlappal
settle_names_order = Az idő alacsony bájtja jön elöl
settle_names_unit = Az idők századmásodpercben vannak
settle_names_count = Az idők a starttól számítanak
settle_names_memories = Az első memória száma 0
settle_names_zeros = Négy nulla elég
settle_names_layout = A funkció a szervó előtt jön
settle_names_stores = Az állások bármely funkciónál megmaradnak
settle_names_moves = Egy beírt állás mozgatja a szervóját
settle_names_unlock = Az UNLOCK válaszának betűje
settle_names_delay = A válasz szokásos ideje
settle_names_reserved = Fenntartott idő, kiolvasva
settle_yes = Igen
settle_no = Nem
settle_unnumbered = Nincs megadott szám
settle_there = Csak ott, ahol a szervók állnak
settle_delay = { $ms } ms
settle_open = Nincs tisztázva
